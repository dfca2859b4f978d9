// Measured metals.
#include "burnish/conductors.hpp"

#include <gtest/gtest.h>

#include "burnish/error.hpp"

namespace burnish {
namespace {

// Linear RGB reflectances at normal incidence as tabulated for artists (Akenine-Moller et al. 2018,
// Real-Time Rendering, table 9.2), from whole spectra and other measurements, hence the tolerance;
// stainless steel is a nearly neutral 0.6.
TEST(Conductors, HaveTheColorsOfTheMetals) {
    const std::pair<const char*, glm::vec3> known[] = {
        {"gold", {1.000f, 0.782f, 0.344f}},     {"silver", {0.972f, 0.960f, 0.915f}},
        {"copper", {0.955f, 0.638f, 0.538f}},   {"aluminium", {0.913f, 0.922f, 0.924f}},
        {"titanium", {0.542f, 0.497f, 0.449f}}, {"brass", {0.910f, 0.778f, 0.423f}},
        {"steel", {0.60f, 0.59f, 0.57f}}};
    EXPECT_EQ(std::size(known), conductor_names().size());
    for (const auto& [name, color] : known) {
        const glm::vec3 found = normal_reflectance(conductor_preset(name));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], color[c], 0.1f) << name << " " << c;
    }
    EXPECT_THROW(conductor_preset("gould"), UsageError);
}

}  // namespace
}  // namespace burnish
