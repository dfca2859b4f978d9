// Errors under held-out lights in known cases: zero, the rounding of the stack's codes, and a known
// share of every sample.
#include "capture/judge/held_out.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/image_io.hpp"
#include "burnish/relight.hpp"
#include "capture/solve/capture_fit.hpp"
#include "support/program.hpp"
#include "tabulate_sample.hpp"

namespace burnish::test {
namespace {

constexpr std::size_t kLights = 12;
constexpr int kHoldOut = 4;  // three of the twelve lights

struct Judged {
    Folder folder;
    TabulatedMaterial material;
    Rig rig;

    Judged() {
        VirtualSettings settings;
        settings.width = 6;
        settings.height = 4;
        const VirtualSample sample = make_virtual_sample("satin", settings);
        material = tabulated(sample, {32, 96});
        rig = make_dome_rig(sample, static_cast<int>(kLights), {});
    }

    // Errors of `material` on pictures of `shown` with all samples multiplied by `factor`.
    std::vector<HeldOutError> errors(const TabulatedMaterial& shown, float factor) {
        const Relighter relighter(shown);
        for (std::size_t k = 0; k < rig.lights.size(); ++k) {
            Image picture = relighter.picture(rig, k);
            for (float& value : picture.pixels) value *= factor;
            const auto path = folder.path(fmt::format("{}.exr", k));
            write_image(path, picture, {});
            rig.lights[k].images = {{path, 1.0}};
        }
        const ImageStack stack(rig, folder.path("pictures.bin"), {});
        return held_out_errors(stack, rig, material, fitted_lights(kLights, kHoldOut), {});
    }
};

void make_black(TabulatedMaterial& material) {
    for (Image* image : {&material.diffuse, &material.specular})
        for (float& value : image->pixels) value = 0.0f;
}

TEST(HeldOut, APerfectFitIsInfinitelyManyDecibels) {
    Judged judged;
    make_black(judged.material);
    // Maps of a model as written by a fit: for black samples its strengths are 0 too.
    for (const char* number : {"alpha_along", "alpha_across", "groove_deg", "diffuse", "specular"})
        judged.material.maps[fmt::format("ward.{}", number)].assign(
            judged.material.texels(), std::string_view(number).starts_with("alpha") ? 0.3f : 0.0f);
    const auto errors = judged.errors(judged.material, 1.0f);
    ASSERT_EQ(errors.size(), 2u);
    for (const HeldOutError& error : errors) {
        EXPECT_GT(error.samples, 20u) << error.model;
        EXPECT_EQ(error.rmse, 0.0) << error.model;
        EXPECT_TRUE(std::isinf(error.psnr) && error.psnr > 0.0) << error.model;
    }
}

// The picture files hold half floats: the relative error of a sample is up to 2^-12, 72 dB if all
// samples were as bright as the peak. Measured 86.9 dB, as most samples are darker.
TEST(HeldOut, ItsOwnPicturesAreRightButForTheirRounding) {
    Judged judged;
    const auto errors = judged.errors(judged.material, 1.0f);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].model, "tabulated");
    EXPECT_GT(errors[0].peak, 0.0);
    EXPECT_GT(errors[0].psnr, 80.0);
    EXPECT_LT(errors[0].psnr, 120.0) << "half floats have no such precision";
}

// Pictures brighter than predicted by a tenth: the error is 1/11 of every sample, so that the RMSE
// is 1/11 of the samples' root mean square, which is at most the peak.
TEST(HeldOut, AKnownErrorIsFound) {
    Judged judged;
    const auto same = judged.errors(judged.material, 1.0f);
    const auto brighter = judged.errors(judged.material, 1.1f);
    EXPECT_EQ(brighter[0].samples, same[0].samples);
    EXPECT_NEAR(brighter[0].peak / same[0].peak, 1.1, 6e-4);  // two half floats: 2^-11
    EXPECT_NEAR(brighter[0].psnr, 20.0 * std::log10(brighter[0].peak / brighter[0].rmse), 1e-9);
    TabulatedMaterial black = judged.material;
    make_black(black);
    Judged dark;
    dark.material = black;
    const auto all = dark.errors(judged.material, 1.1f);  // the error equals the sample
    EXPECT_NEAR(brighter[0].rmse / all[0].rmse, 1.0 / 11.0, 1e-3);
}

TEST(HeldOut, WithoutHeldOutLightsThereIsNothingToSay) {
    Judged judged;
    const Relighter relighter(judged.material);
    judged.errors(judged.material, 1.0f);
    const ImageStack stack(judged.rig, judged.folder.path("pictures.bin"), {});
    EXPECT_TRUE(
        held_out_errors(stack, judged.rig, judged.material, fitted_lights(kLights, 0), {}).empty());
    // All texels are outside the mask: lights judge the fit, but no sample is valid.
    judged.material.exemplar.assign(judged.material.texels(), TabulatedMaterial::kNoExemplar);
    const auto errors =
        held_out_errors(stack, judged.rig, judged.material, fitted_lights(kLights, kHoldOut), {});
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].samples, 0u);
    EXPECT_TRUE(std::isnan(errors[0].psnr));
}

}  // namespace
}  // namespace burnish::test
