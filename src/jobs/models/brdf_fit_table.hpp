// The fits of measured materials as text: a table for reading, CSV and JSON. Private to
// fit_measured.
#pragma once

#include <span>
#include <string>

#include "jobs/models/brdf_fit.hpp"

namespace burnish {

std::string fit_lines(const MeasuredFit& fit);
// p0 .. p4 are those of `brdf eval`, with the model's own ks at 1.
std::string fit_csv(std::span<const MeasuredFit> fits, const std::string& command);
std::string fit_json(std::span<const MeasuredFit> fits, const std::string& command);

}  // namespace burnish
