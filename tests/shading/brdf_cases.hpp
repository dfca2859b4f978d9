// Every reflection model with parameters that stand for it, and its albedo.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "burnish/brdf_models.hpp"
#include "core/text.hpp"
#include "lobes_under_test.hpp"
#include "models/albedo.hpp"

namespace burnish::test {

struct BrdfCase {
    const BrdfModel* model;
    std::array<double, kMostBrdfParameters> p;

    double f(vec3 wi, vec3 wo) const { return model->value_f64(p, wi, wo); }
    double density(vec3 wi, vec3 wo) const { return model->sampler_f64.density(p, wi, wo); }
    vec3 sample(vec3 wo, std::array<double, 3> xi, double& found) const {
        return model->sampler_f64.sample(p, wo, xi, found);
    }
};

inline const BrdfModel& model_named(std::string_view name) {
    return brdf_models()[static_cast<std::size_t>([&] {
        std::vector<std::string_view> names;
        for (const BrdfModel& model : brdf_models()) {
            names.push_back(model.name);
        }
        return index_of_name(names, name, "model", "test");
    }())];
}

// Fresnel and ks are 1, so that albedos are those of a white surface; phong's and lafortune's ks is
// that of a lobe which has albedo 1 seen head-on.
inline std::vector<BrdfCase> brdf_cases() {
    const auto at = [](std::string_view name, std::array<double, kMostBrdfParameters> p) {
        return BrdfCase{&model_named(name), p};
    };
    const double cosine_lobe = (20 + 2) / (2 * std::numbers::pi);
    return {at("ashikhmin-shirley", {200, 10, 1}),
            at("ashikhmin-shirley-diffuse", {1, 0}),
            at("ashikhmin-premoze-shirley", {200, 10, 1}),
            at("ward", {1, 0.15, 0.4}),
            at("ward-duer", {1, 0.15, 0.4}),
            at("ward-gmd", {1, 0.15, 0.4}),
            at("cook-torrance", {1, 0.3, 1}),
            at("lafortune", {cosine_lobe, -1, -1, 0.95, 20}),
            at("phong", {cosine_lobe, 20}),
            at("he", {0.2, 3, 1}),
            at("he", {1, 10, 1}),
            at("ggx", {0.15, 0.4, 1}),
            at("ggx-separable", {0.15, 0.4, 1}),
            at("beckmann", {0.15, 0.4, 1})};
}

inline std::string label(const BrdfCase& c) {
    std::string text(c.model->name);
    for (std::size_t i = 0; i < c.model->parameters.size(); ++i) {
        std::array<char, 32> number{};
        std::snprintf(number.data(), number.size(), "%.4g", c.p[i]);
        text += (i == 0 ? " (" : ", ") + std::string(number.data());
    }
    return text + ")";
}

inline double albedo(const BrdfCase& c, vec3 wi, int points = 1 << 13) {
    return directional_albedo(*c.model, c.p, wi, points);
}

inline vec3 at_deg(double theta_deg, double phi_deg) {
    return direction(theta_deg * kPi / 180, phi_deg * kPi / 180);
}

}  // namespace burnish::test
