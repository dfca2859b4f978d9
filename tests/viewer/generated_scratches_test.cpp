// The generator of scratches: coarse maps against full ones, folders of the cache, saved scenes.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <set>

#include "burnish/error.hpp"
#include "burnish/scratch_maps.hpp"
#include "core/memory.hpp"
#include "maps/scratch/scratch_coarse.hpp"
#include "viewer/document/editor.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/generate/save_maps.hpp"
#include "viewer/generate/scratches.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;

using test::error_line;
using test::expect_same_stage;
using test::ScratchFolder;
using test::two_materials;

double rms_slope(const ScratchMaps& maps) {
    double sum = 0.0;
    for (int y = 0; y < maps.size; ++y)
        for (int x = 0; x < maps.size; ++x) {
            const auto [sx, sy] = slope_at(maps, x, y);
            sum += static_cast<double>(sx * sx + sy * sy);
        }
    return std::sqrt(sum) / maps.size;
}

// A small map, so that tests are quick: a tile of 10 mm on 256 texels, as dense as the usual 50 mm on
// 1280.
ScratchRecipe small_recipe(std::uint32_t seed = 1) {
    ScratchRecipe recipe;
    recipe.settings = scratch_preset("fine-random", "test");
    recipe.settings.tile_mm = 10.0;
    recipe.settings.size = 256;
    recipe.settings.seed = seed;
    // The cut of a lognormal at three deviations would be longer than four tiles.
    set_typical(recipe.settings.layers.front().length_mm, 2.0);
    return recipe;
}

// Without the correction the ratio is 0.1 to 0.6: grooves are a texel of the coarse map wide.
TEST(CoarseScratches, HaveTheSlopesOfTheFullMap) {
    for (const std::string_view name : scratch_preset_names())
        for (const double amount : {0.25, 1.0, 4.0}) {
            ScratchSettings settings = scaled_scratches(scratch_preset(name, "test"), amount, 1.0);
            const int size = coarse_scratch_size(settings);
            EXPECT_GE(size, 128);
            EXPECT_LE(size, 512);
            const double coarse = rms_slope(engrave_coarse(settings, {}, size));
            const double full = rms_slope(engrave(settings, {}, available_memory()));
            // The windows are some percent of the tile: rare furrows are seen by few of them. 15 % of
            // roughness is what one sees when two pictures change places.
            EXPECT_NEAR(coarse / full, 1.0, 0.15) << name << ", amount " << amount;
        }
}

TEST(CoarseScratches, DeeperScratchesAreAsMuchSteeper) {
    const ScratchSettings settings = scratch_preset("brushed", "test");
    const double once = rms_slope(engrave_coarse(settings, {}, 256));
    const double twice = rms_slope(engrave_coarse(scaled_scratches(settings, 1.0, 2.0), {}, 256));
    // Caps of spheres become a little rounder with depth: a sixth of the width at the most here.
    EXPECT_NEAR(twice / once, 2.0, 0.1);
}

TEST(CoarseScratches, AreTheMapItselfWhereThatIsSmall) {
    const ScratchRecipe recipe = small_recipe();
    ASSERT_EQ(coarse_scratch_size(recipe.settings), 256);
    const ScratchTextures coarse = coarse_scratches(recipe);
    const ScratchMaps full = engrave(recipe.settings, {}, available_memory());
    EXPECT_EQ(coarse.normal.texels,
              scratch_textures(full, recipe.settings.layers.front()).normal.texels);
    EXPECT_EQ(coarse.tile_mm, 10.0);
}

TEST(GeneratedScratches, ChoicesAreWhatTheCommandEngraves) {
    ScratchChoice choice = scratch_choice("brushed");
    choice.amount = 3.0;
    choice.strength = 0.5;
    const ScratchSettings preset = scratch_preset("brushed", "test");
    const ScratchSettings made = scratch_recipe(choice).settings;
    for (std::size_t i = 0; i < preset.layers.size(); ++i) {
        EXPECT_DOUBLE_EQ(made.layers[i].density_per_cm2, 3.0 * preset.layers[i].density_per_cm2);
        EXPECT_DOUBLE_EQ(made.layers[i].depth_mm.typical(),
                         0.5 * preset.layers[i].depth_mm.typical());
        EXPECT_EQ(made.layers[i].width_mm, preset.layers[i].width_mm);
    }
    Spread spread = parse_spread("normal:4:1", "test");
    set_typical(spread, 8.0);
    EXPECT_EQ(to_text(spread), "normal:8:2");
    EXPECT_NE(error_line([] { scratch_choice("brusht"); }).find("did you mean 'brushed'?"),
              std::string::npos);
}

TEST(GeneratedScratches, TheKeyIsThatOfTheSettings) {
    const std::string key = scratch_recipe_key(small_recipe());
    EXPECT_EQ(key, scratch_recipe_key(small_recipe()));
    EXPECT_EQ(key.size(), 16u);
    EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
    std::set<std::string> keys{key, scratch_recipe_key(small_recipe(2))};
    ScratchRecipe other = small_recipe();
    other.settings.size = 512;
    keys.insert(scratch_recipe_key(other));
    other = small_recipe();
    other.settings.layers.back().range_deg = 1e-9;
    keys.insert(scratch_recipe_key(other));
    // A picture that is written anew gives other maps.
    const ScratchFolder folder;
    other = small_recipe();
    other.wear_mask = folder.write("mask.png", "one");
    keys.insert(scratch_recipe_key(other));
    folder.write("mask.png", "another");
    keys.insert(scratch_recipe_key(other));
    EXPECT_EQ(keys.size(), 6u);
}

TEST(GeneratedScratches, AreMadeOnceAndReadAsTheirSettings) {
    const ScratchFolder folder;
    const fs::path cache = folder / "deep/cache";
    const fs::path made = make_cached_scratches(cache, small_recipe(), {});
    EXPECT_EQ(made, scratch_folder(cache, small_recipe()));
    EXPECT_EQ(scratch_choice(made.string()).recipe.settings, small_recipe().settings);
    const auto written = fs::last_write_time(made / "normal.png");
    EXPECT_EQ(make_cached_scratches(cache, small_recipe(), {}), made);
    EXPECT_EQ(fs::last_write_time(made / "normal.png"), written);
    // A folder that was not finished is made again.
    fs::remove(made / "scratch.json");
    make_cached_scratches(cache, small_recipe(), {});
    EXPECT_TRUE(fs::exists(made / "scratch.json"));
    // One that is used now is kept, an old one goes.
    const fs::path old = make_cached_scratches(cache, small_recipe(2), {});
    fs::last_write_time(old / "scratch.json",
                        fs::file_time_type::clock::now() - std::chrono::hours(48));
    prune_scratch_cache(cache, 1);
    EXPECT_TRUE(fs::exists(made));
    EXPECT_FALSE(fs::exists(old));
}

TEST(GeneratedScratches, AFolderThatCannotBeWrittenIsAMessage) {
    const ScratchFolder folder;
    folder.write("file", "");
    const std::string line =
        error_line([&] { make_cached_scratches(folder / "file/cache", small_recipe(), {}); });
    EXPECT_NE(line.find("a folder for scratch maps"), std::string::npos) << line;
}

// What another thread has read is what the editor would have read; then the folder is not looked at.
TEST(GeneratedScratches, MapsThatWereReadAreTaken) {
    const ScratchFolder folder;
    const std::string made = make_cached_scratches(folder / "cache", small_recipe(), {}).string();
    Document document;
    document.input = two_materials(folder, "two.glb").string();
    document.environment = "none";
    Editor reads, takes;
    reads.open(document);
    takes.open(document);
    takes.put_scratch(made, load_scratch(made, true));
    set_parameter(document, "scratch", made);
    reads.set(document);
    fs::remove_all(made);
    takes.set(document);
    expect_same_stage(takes.stage(), reads.stage());
    // Once: a folder that is read anew is the one on disk.
    set_parameter_text(document, "scratch_direction", "follow");
    EXPECT_THROW(takes.set(document), UsageError);
}

// The scene is moved, and the cache is gone: it is drawn as before.
TEST(GeneratedScratches, ASavedSceneHasItsOwnCopy) {
    const ScratchFolder folder;
    const fs::path cache = folder / "state/scratches";
    Document document;
    fs::create_directories(folder / "work");
    document.input = two_materials(folder, "work/two.glb").string();
    document.environment = "none";
    const std::string first = make_cached_scratches(cache, small_recipe(), {}).string();
    const std::string second = make_cached_scratches(cache, small_recipe(2), {}).string();
    set_parameter(document, "scratch", first);
    set_parameter(document, "scratch", second, 1);
    set_parameter_text(document, "scratch_direction", "follow", 1);
    Editor editor;
    editor.open(document);
    save_scene(editor.document(), editor.stage(), folder / "work/worn.json", cache);
    EXPECT_TRUE(
        fs::exists(folder / "work/worn.scratch" / fs::path(first).filename() / "normal.png"));
    fs::remove_all(folder / "state");
    fs::rename(folder / "work", folder / "moved");
    StageRequest request;
    request.input = (folder / "moved/worn.json").string();
    expect_same_stage(set_stage(request), editor.stage());
    Editor again;
    again.open({.input = request.input});
    expect_same_stage(again.stage(), editor.stage());
    EXPECT_EQ(scratch_choice(scratches_of(again.stage(), 1)).recipe.settings,
              small_recipe(2).settings);
    // Saved once more it names the same folders.
    save_scene(again.document(), again.stage(), request.input, cache);
    expect_same_stage(set_stage(request), editor.stage());
}

TEST(GeneratedScratches, MapsAreSavedAsTheirCommandsMakeThem) {
    const ScratchFolder folder;
    Document document;
    document.input = two_materials(folder, "two.glb").string();
    document.environment = "none";
    EXPECT_NE(error_line([&] {
                  maps_request(load_stage(document), std::nullopt, folder / "maps");
              }).find("scratches or a weave, whose maps can be saved"),
              std::string::npos);
    const fs::path made = make_cached_scratches(folder / "cache", small_recipe(), {});
    set_parameter(document, "scratch", made.string(), 0);
    set_parameter_text(document, "weave", "twill-2-1", 1);
    set_parameter_text(document, "weave_crimp", "0.3", 1);
    const Stage stage = load_stage(document);
    const MapsRequest scratches = maps_request(stage, std::nullopt, folder / "maps");
    EXPECT_EQ(scratches.what, "scratches of brass");
    EXPECT_EQ(std::get<ScratchRequest>(scratches.maps).recipe.settings, small_recipe().settings);
    make_maps(scratches, {});
    EXPECT_TRUE(fs::exists(folder / "maps/moments.exr"));
    EXPECT_EQ(load_scratch_recipe(folder / "maps").settings, small_recipe().settings);
    const MapsRequest weave = maps_request(stage, 1, folder / "cloth");
    EXPECT_EQ(weave.what, "weave of oak");
    EXPECT_EQ(std::get<WeaveRequest>(weave.maps).weave, "twill-2-1");
    EXPECT_EQ(std::get<WeaveRequest>(weave.maps).values.real("weave_crimp"), 0.3);
}

TEST(GeneratedScratches, PreviewsRepeatAsTheMapWill) {
    const ScratchFolder folder;
    Document document;
    document.input = two_materials(folder, "two.glb").string();
    document.environment = "none";
    const fs::path made = make_cached_scratches(folder / "cache", small_recipe(), {});
    set_parameter(document, "scratch", made.string(), 0);
    set_parameter(document, "physical_size", true, 0);
    set_parameter_text(document, "weave", "plain", 1);
    const Stage stage = load_stage(document);
    // The cloth stays cloth.
    const std::vector<ScratchPreview> same = scratch_previews(stage, std::nullopt, 10.0);
    ASSERT_EQ(same.size(), 1u);
    EXPECT_TRUE(same[0].shown == stage.scene.materials[0]);
    const std::vector<ScratchPreview> halved = scratch_previews(stage, 0, 5.0);
    // Floats: the scale is one rounding of a double.
    EXPECT_FLOAT_EQ(halved[0].shown.normal_texture.transform[0][0],
                    2.0f * same[0].shown.normal_texture.transform[0][0]);
    set_parameter(document, "uv_scale", 3.0, 0);
    EXPECT_EQ(
        scratch_previews(load_stage(document), 0, 5.0)[0].shown.normal_texture.transform[0][0],
        3.0f);
}

}  // namespace
}  // namespace burnish::viewer
