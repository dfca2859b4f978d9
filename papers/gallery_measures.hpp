// Measurements of lobes and pictures for the gallery. Private to papers/gallery*.
#pragma once

#include "burnish/image.hpp"
#include "burnish/plot/mdf_plot.hpp"
#include "core/constants.hpp"

namespace burnish {

// Moments of the lobe as a mass on the disk of half vectors, D_proj dp with dp = (n.h) dw: its
// energy, center and width. By the midpoint rule on a square grid of 1001 points on a side;
// accurate to 0.1 % for lobes with exponents below 2000.
struct LobeMoments {
    double energy = 0;     // Int D_proj (n.h) dw; 1 for an unperturbed lobe
    double long_axis = 0;  // standard deviations along the principal axes
    double short_axis = 0;
    double elongation() const { return long_axis / short_axis; }
};
LobeMoments lobe_moments(const plot::MdfSubject& subject);

// Angle between the brightest half vector and n~, in degrees.
double peak_offset_deg(const plot::MdfSubject& subject);

// Angle from the peak at which D is half of its peak, in degrees, along x or y (unperturbed lobes).
double half_width_deg(const plot::MdfSubject& subject, plot::ProfileLine line);

// Bend, in degrees, of lines through the pole at its transformed position: the largest angle
// between the two sides of the image of a straight line through C.
double bend_at_center_deg(const plot::MdfSubject& subject);

// ---- pictures: linear RGBA of one size; `mask` has one channel and counts where above 1/2

float luminance(const Image& linear, std::size_t pixel);
// rms(a - reference) / rms(reference) of the luminance.
double relative_difference(const Image& a, const Image& reference, const Image& mask);
// The same in the skirts of the highlight only: where the reference has 2 to 50 % of its brightest
// hundredth.
double skirt_difference(const Image& a, const Image& reference, const Image& mask);
// Share of the squares of `side` pixels, completely within the mask, whose luminance varies by less
// than 25 % (rms) of its mean: there a smaller pattern is invisible.
double flat_share(const Image& linear, const Image& mask, int side);
// Ratio of the least luminance of the brightest hundredth to the mean.
double concentration(const Image& linear, const Image& mask);
// Correlation of the luminances of two pictures.
double correlation(const Image& a, const Image& b, const Image& mask);
// Ratio of the principal axes of the highlight: second moments of the pixels above half of the
// brightest hundredth.
double highlight_elongation(const Image& linear, const Image& mask);

}  // namespace burnish
