// What the gallery measures about lobes and pictures. Private to app/gallery*.
#pragma once


#include "burnish/image.hpp"
#include "burnish/plot/mdf_plot.hpp"
#include "core/constants.hpp"

namespace burnish {


// The lobe as a mass on the disk of half vectors, D_proj dp with dp = (n.h) dw: how much there is,
// where it lies and how wide it is. By the midpoint rule on a square grid of 1001 points a side,
// good to 0.1 % for lobes wider than exponents of 2000.
struct LobeMoments {
    double energy = 0;     // Int D_proj (n.h) dw; 1 for an unperturbed lobe
    double long_axis = 0;  // standard deviations along the principal axes
    double short_axis = 0;
    double elongation() const { return long_axis / short_axis; }
};
LobeMoments lobe_moments(const plot::MdfSubject& subject);

// Degrees between the brightest half vector and n~.
double peak_offset_deg(const plot::MdfSubject& subject);

// Half the angle at which D falls to half of its peak, in degrees, along x or y (unperturbed
// lobes).
double half_width_deg(const plot::MdfSubject& subject, plot::ProfileLine line);

// By how many degrees lines through the pole are bent where it has been moved to: the largest angle
// between the two sides of the image of a straight line through C.
double bend_at_center_deg(const plot::MdfSubject& subject);

// ---- pictures, linear RGBA of one size; `mask` one channel: only where it is above 1/2
// -------------

float luminance(const Image& linear, std::size_t pixel);
// rms(a - reference) / rms(reference) of the luminance.
double relative_difference(const Image& a, const Image& reference, const Image& mask);
// The same only in the skirts of the highlight: where the reference has 2 to 50 % of its brightest
// hundredth.
double skirt_difference(const Image& a, const Image& reference, const Image& mask);
// Share of the squares of `side` pixels, whole within the mask, whose luminance varies by less than
// 25 % (rms) of its mean: where a pattern smaller than that is not to be seen.
double flat_share(const Image& linear, const Image& mask, int side);
// The least luminance of the brightest hundredth over the mean.
double concentration(const Image& linear, const Image& mask);
// Correlation of the luminances.
double correlation(const Image& a, const Image& b, const Image& mask);
// Ratio of the principal axes of the highlight: second moments of what is above half the brightest
// hundredth.
double highlight_elongation(const Image& linear, const Image& mask);

}  // namespace burnish
