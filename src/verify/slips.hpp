// What may have happened to a reflection model on its way into somebody's program, as functions: another method,
// and the usual slips. `burnish verify --csv` looks for the one that explains a table of values.
#pragma once

#include <string>
#include <vector>

#include "verify/process_plate.hpp"

namespace burnish::verify {

enum class AlphaSlip { none, swapped, squared, rooted };
// What happened to the value: times the cosine of the light; without 1/(4 cos cos); with the visibility G/(4 cos
// cos) cut off at 1; without masking; without Fresnel.
enum class ValueSlip { none, cosine, no_denominator, clamped_visibility, no_masking, no_fresnel };

struct Guess {
    Subject subject;  // the lobe before its slip
    AlphaSlip alpha = AlphaSlip::none;
    ValueSlip value = ValueSlip::none;
    double scale = 1;
};

// The directions of a table, and what they are under.
struct Sightings {
    std::vector<vec3> wi, wo;
    vec3 n{0, 0, 1};  // the perturbed normal
    double f0 = 1;    // Schlick's
};

// The subject whose lobe has slipped.
Subject slipped(const Subject& subject, AlphaSlip slip);

// f of the subject for every row, and what the slips of the value need. Fresnel included.
struct GuessValues {
    std::vector<double> f;
    std::vector<double> of(ValueSlip slip, const Sightings& at) const;

    std::vector<double> fresnel;     // F
    std::vector<double> visibility;  // G/(4 cos cos); 0 of models without facets
};
GuessValues values_of(const Subject& subject, const Sightings& at);

// "normal-map: the lobe is in the unperturbed frame, ...".
std::string words_of_method(int method);
// "alpha_x and alpha_y are exchanged"; "" for none.
std::string words_of_slip(AlphaSlip slip);
std::string words_of_slip(ValueSlip slip);
// "all values are 0.318 of ours, which is 1/pi".
std::string words_of_scale(double scale);

}  // namespace burnish::verify
