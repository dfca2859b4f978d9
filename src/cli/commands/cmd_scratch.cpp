// burnish scratch: maps of scratched metal.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/session.hpp"
#include "core/text.hpp"
#include "jobs/maps/scratch.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kScratchFooter = R"(
Lengths are millimetres on the surface, angles degrees, counter-clockwise. LENGTH, WIDTH, DEPTH and
CURVATURE are a number, uniform:FROM:TO, normal:MEAN:SD or lognormal:MEDIAN:SIGMA. The flags of one
layer change the first layer of the preset or file; --add-layer takes the same words without dashes.
With neither preset nor file the first layer starts as 40 round scratches/cm2 of any direction, 5 mm x 0.1 mm,
0.01 mm deep, straight, thinning out over their whole length.

Writes into DIR: height.exr (millimetres), height.png, normal.png (+y up), direction.png (groove, double
angle), anisotropy.png (KHR_materials_anisotropy), moments.exr (mip map), preview.png, scratch.json.
docs/reference/map-folders.md says what each holds.

Examples:
  burnish scratch -o metal --preset brushed --size 4096
  burnish scratch -o worn --density 40 --length lognormal:6:0.5 --width 0.08 --depth 0.01 \
      --direction constant --angle 30 --range 15 --wear-mask wear.png
  burnish scratch -o more --settings metal --strength 1.5 \
      --add-layer "density=2,length=12,width=0.4,depth=0.05,profile=burr")";

double number_of(const std::string& text, const std::string& where) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (status != std::errc{} || stop != end || !std::isfinite(value))
        throw UsageError(where, "", "a number", shown(text));
    return value;
}

using SetLayer =
    std::function<void(ScratchLayer&, const std::string& text, const std::string& where)>;

struct LayerWord {
    const char* name;
    const char* type;
    const char* help;
    SetLayer set;
};

SetLayer sets_number(double ScratchLayer::*member) {
    return [member](ScratchLayer& layer, const std::string& text, const std::string& where) {
        layer.*member = number_of(text, where);
    };
}

SetLayer sets_spread(Spread ScratchLayer::*member) {
    return [member](ScratchLayer& layer, const std::string& text, const std::string& where) {
        layer.*member = parse_spread(text, where);
    };
}

template <typename Name>
SetLayer sets_name(Name ScratchLayer::*member, std::span<const std::string_view> names) {
    return [=](ScratchLayer& layer, const std::string& text, const std::string& where) {
        layer.*member = static_cast<Name>(index_of_name(names, text, "word", where));
    };
}

// The properties of a layer that flags and --add-layer can set.
const std::vector<LayerWord>& layer_words() {
    static const std::vector<LayerWord> words = {
        {"count", "N", "scratches on the tile; instead of --density",
         [](ScratchLayer& layer, const std::string& text, const std::string& where) {
             layer.count = number_of(text, where);
             layer.density_per_cm2 = 0.0;
         }},
        {"density", "N", "scratches per square centimetre",
         [](ScratchLayer& layer, const std::string& text, const std::string& where) {
             layer.density_per_cm2 = number_of(text, where);
             layer.count = 0.0;
         }},
        {"length", "LENGTH", "length [mm]", sets_spread(&ScratchLayer::length_mm)},
        {"width", "WIDTH", "width where it is widest [mm]", sets_spread(&ScratchLayer::width_mm)},
        {"depth", "DEPTH", "depth, half the width at most [mm]",
         sets_spread(&ScratchLayer::depth_mm)},
        {"curvature", "CURVATURE", "1 / radius [1/mm], besides what the direction field bends",
         sets_spread(&ScratchLayer::curvature_per_mm)},
        {"taper", "SHARE", "share of the length that thins out, 0.01 to 1",
         sets_number(&ScratchLayer::taper)},
        {"profile", "NAME", "round, v or burr (with raised lips)",
         sets_name(&ScratchLayer::profile, scratch_profile_names())},
        {"direction", "NAME", "random, constant, circular, radial or image",
         sets_name(&ScratchLayer::field, scratch_field_names())},
        {"angle", "DEG", "direction of constant; turns circular, radial and image",
         sets_number(&ScratchLayer::angle_deg)},
        {"range", "DEG", "scatter to either side of the direction, 0 to 90",
         sets_number(&ScratchLayer::range_deg)},
        {"placement", "NAME", "random, or even: spaced evenly across a constant direction",
         sets_name(&ScratchLayer::placement, scratch_placement_names())},
        {"passes", "N", "of even: how often the tool comes back over the tile; 0: anywhere",
         sets_number(&ScratchLayer::passes)},
    };
    return words;
}

struct ScratchFlags {
    std::string output, preset, settings, wear_mask, direction_image;
    bool double_angle = false, orm = false;
    std::optional<int> size;
    std::optional<double> tile_mm;
    std::optional<std::uint32_t> seed;
    double amount = 1.0, strength = 1.0;
    std::map<std::string, std::string> words;  // values for the first layer
    std::vector<std::string> layers;
    std::string command;
};

// Parses a layer such as "density=2,length=12".
ScratchLayer parse_layer(const std::string& text) {
    ScratchLayer layer;
    std::size_t start = 0;
    std::map<std::string, std::string> given;
    while (start <= text.size()) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        const std::string part = text.substr(start, comma - start);
        const std::size_t equals = part.find('=');
        if (equals == std::string::npos)
            throw UsageError("--add-layer", "", "word=value,word=value", shown(part));
        const std::string name = part.substr(0, equals);
        std::vector<std::string_view> names;
        for (const LayerWord& word : layer_words()) names.push_back(word.name);
        const int index = index_of_name(names, name, "word", "--add-layer");
        if (!given.emplace(name, "").second)
            throw UsageError("--add-layer", name, "it once", "it twice");
        layer_words()[static_cast<std::size_t>(index)].set(layer, part.substr(equals + 1),
                                                           "--add-layer: " + name);
        start = comma + 1;
    }
    if (given.contains("count") && given.contains("density"))
        throw UsageError("--add-layer", "", "a count or a density, not both", "both");
    if (!given.contains("count") && !given.contains("density"))
        throw UsageError("--add-layer", "", "a count or a density", shown(text));
    return layer;
}

ScratchRecipe base_recipe(const ScratchFlags& flags) {
    if (!flags.preset.empty() && !flags.settings.empty())
        throw UsageError("--preset", "", "a preset or --settings, not both", "both");
    if (!flags.settings.empty()) return load_scratch_recipe(flags.settings);
    ScratchRecipe recipe;
    if (!flags.preset.empty()) {
        recipe.settings = scratch_preset(flags.preset, "--preset");
        return recipe;
    }
    ScratchLayer layer;
    layer.density_per_cm2 = 40.0;
    recipe.settings.layers = {layer};
    return recipe;
}

void change_first_layer(const ScratchFlags& flags, ScratchLayer& layer) {
    if (flags.words.contains("count") && flags.words.contains("density"))
        throw UsageError("--count", "", "a count or a --density, not both", "both");
    for (const LayerWord& word : layer_words()) {
        const auto found = flags.words.find(word.name);
        if (found != flags.words.end())
            word.set(layer, found->second, "--" + std::string(word.name));
    }
    const bool named = flags.words.contains("direction");
    if (!flags.direction_image.empty() && !named) layer.field = ScratchField::image;
    // The field `random` has neither angle nor scatter: those of a preset are reset, those given by
    // the user are an error.
    if (named && layer.field == ScratchField::random) {
        if (!flags.words.contains("angle")) layer.angle_deg = 0.0;
        if (!flags.words.contains("range")) layer.range_deg = 0.0;
    }
}

ScratchRecipe recipe_of(const ScratchFlags& flags) {
    ScratchRecipe recipe = base_recipe(flags);
    ScratchSettings& settings = recipe.settings;
    if (flags.size) settings.size = *flags.size;
    if (flags.tile_mm) settings.tile_mm = *flags.tile_mm;
    if (flags.seed) settings.seed = *flags.seed;
    if (!flags.wear_mask.empty()) recipe.wear_mask = flags.wear_mask;
    if (!flags.direction_image.empty()) {
        recipe.direction_image = flags.direction_image;
        recipe.direction_is_double_angle = flags.double_angle;
    } else if (flags.double_angle) {
        throw UsageError("--double-angle", "", "a --direction-image beside it", "none");
    }
    change_first_layer(flags, settings.layers.front());
    for (const std::string& text : flags.layers) settings.layers.push_back(parse_layer(text));
    settings = scaled_scratches(std::move(settings), flags.amount, flags.strength);
    return recipe;
}

void run_scratch(const ScratchFlags& flags, const Session& session) {
    const ScratchRequest request{recipe_of(flags), flags.orm, flags.output, session.command_line()};
    const ScratchReport report = make_scratch_maps(request, session.progress());
    print_report(report.warnings, report.written,
                 {fmt::format("process: {} (render with --process {})", name_of(kScratchProcess),
                              name_of(kScratchProcess))});
}

void add_layer_flags(CLI::App& command, const std::shared_ptr<ScratchFlags>& flags) {
    for (const LayerWord& word : layer_words()) {
        const std::string name = word.name;
        command
            .add_option_function<std::string>(
                "--" + name, [flags, name](const std::string& text) { flags->words[name] = text; },
                word.help)
            ->type_name(word.type)
            ->group("First layer");
    }
    command.add_option("--add-layer", flags->layers, "one more layer of wear: word=value,...")
        ->type_name("WORDS")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->allow_extra_args(false);
}

}  // namespace

void add_scratch_command(CLI::App& parent, Session& session) {
    CLI::App* command = parent.add_subcommand("scratch", "Make maps of scratched metal");
    const auto flags = std::make_shared<ScratchFlags>();
    command->add_option("-o,--output", flags->output, "folder to write into; made when needed")
        ->required()
        ->type_name("DIR");
    command
        ->add_option("--preset", flags->preset,
                     fmt::format("{}", fmt::join(scratch_preset_names(), ", ")))
        ->type_name("NAME");
    command
        ->add_option("--settings", flags->settings,
                     "a scratch.json, or the folder of an earlier run")
        ->type_name("FILE|DIR");
    command
        ->add_option_function<std::string>(
            "--size",
            [flags](const std::string& text) {
                flags->size = whole_number(text, {16, 16384}, "--size");
            },
            "texels a side, 16 to 16384 (default 2048)")
        ->type_name("N");
    command->add_option("--tile-mm", flags->tile_mm, "side of the tile on the surface (default 50)")
        ->type_name("MM");
    command
        ->add_option_function<std::string>(
            "--seed",
            [flags](const std::string& text) {
                flags->seed =
                    static_cast<std::uint32_t>(whole_number(text, {0, 2147483647}, "--seed"));
            },
            "seed of all random choices, 0 to 2147483647 (default 1)")
        ->type_name("N");
    command->add_option("--amount", flags->amount, "factor on the number of scratches")
        ->type_name("X")
        ->check(CLI::Range(0.0, 1000.0));
    command->add_option("--strength", flags->strength, "factor on all depths")
        ->type_name("X")
        ->check(CLI::Range(0.0, 1000.0));
    command
        ->add_option("--wear-mask", flags->wear_mask,
                     "square picture of any size: white is worn, black untouched")
        ->type_name("FILE");
    command
        ->add_option("--direction-image", flags->direction_image,
                     "square picture: red and green an arrow along the grain, +y up")
        ->type_name("FILE");
    command->add_flag("--double-angle", flags->double_angle,
                      "the direction image holds cos 2a, sin 2a, as direction.png does");
    command->add_flag("--orm", flags->orm,
                      "also ao.png and orm.png: occlusion, roughness 0.3, metal");
    add_layer_flags(*command, flags);
    command->footer(kScratchFooter);
    command->callback([flags, &session] { run_scratch(*flags, session); });
}

}  // namespace burnish::cli
