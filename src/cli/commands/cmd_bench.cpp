// burnish bench: costs of work on this machine.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/frame/frame_cost.hpp"
#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/integer_flag.hpp"
#include "cli/session.hpp"
#include "cli/usage.hpp"
#include "core/memory.hpp"

namespace burnish::cli {
namespace {

constexpr const char* kBenchFooter = R"(
Techniques: gouraud, aniso (the anisotropic lobe without the normal map), the methods of `burnish
render --method` (normal-map, gram-schmidt, rotate-exact, rotate-approx, rotate-arc, follow-grain,
deform-linear, deform-smooth, slope-shift, stretch), follow-grain under image light
(image-importance, image-prefiltered, image-bent-normal), and follow-grain of a measured material
made of tables: of many texels, of which four are shaded in a pixel (tabulated), and of one
(tabulated-one). gouraud and normal-map are what the others are compared to; they are always
measured.

Every mesh is drawn at every size where --size or --triangles is given; without the other that is
4096 and 102400 triangles, or 1280x720.

Writes OUT.json (every sample), OUT.md (tables beside the papers' figures) and OUT.svg (bars).
Without -o the tables are printed. Nothing else should run meanwhile: the load average is kept in the
result. On two cores without a GPU the whole takes about a quarter of an hour, --quick less than a
minute.

Examples:
  burnish bench frame --quick
  burnish bench frame -o frames.json
  burnish bench frame --size 1280x720,3840x2160 --triangles 4k,1M \
      --methods rotate-exact,rotate-approx --pairs 31 -o rotations.json)";

struct BenchFlags {
    std::optional<std::string> sizes, triangles, methods, output;
    int pairs = 0;  // 0: not given
    int gl_device = -1;
    bool quick = false;
};

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> parts;
    std::size_t start = 0;
    while (start <= list.size()) {
        const std::size_t comma = std::min(list.find(',', start), list.size());
        parts.push_back(list.substr(start, comma - start));
        start = comma + 1;
    }
    return parts;
}

// The number at the start of `text`, and the text after it.
struct Leading {
    int value = 0;
    std::string_view rest;
    bool found = false;
};

Leading leading_number(std::string_view text) {
    Leading number;
    const auto [stop, status] =
        std::from_chars(text.data(), text.data() + text.size(), number.value);
    number.found = status == std::errc{};
    number.rest = text.substr(static_cast<std::size_t>(stop - text.data()));
    return number;
}

struct Size {
    int width = 0, height = 0;
};

Size parse_size(const std::string& text) {
    const Leading width = leading_number(text);
    if (width.found && width.rest.starts_with('x')) {
        const Leading height = leading_number(width.rest.substr(1));
        if (height.found && height.rest.empty()) return {width.value, height.value};
    }
    throw UsageError("--size", "", "WIDTHxHEIGHT, such as 1280x720", shown(text));
}

// "4096", "4k" (4,000), "1M"
int parse_triangles(const std::string& text) {
    const Leading number = leading_number(text);
    const std::string_view rest = number.rest;
    const int times = rest.empty() ? 1 : rest == "k" ? 1000 : rest == "M" ? 1000000 : 0;
    if (!number.found || times == 0 || number.value <= 0 || number.value > 4000000 / times)
        throw UsageError("--triangles", "", "a number from 100 to 4M, such as 4096, 102k or 1M",
                         shown(text));
    return number.value * times;
}

// The combinations of meshes and sizes when either flag is given; the missing flag has the quick
// default.
std::vector<FrameCase> cases_of(const BenchFlags& flags) {
    if (!flags.sizes && !flags.triangles) return default_frame_cases(flags.quick);
    std::vector<Size> sizes;
    std::vector<int> meshes;
    if (flags.sizes)
        for (const std::string& text : split(*flags.sizes)) sizes.push_back(parse_size(text));
    if (flags.triangles)
        for (const std::string& text : split(*flags.triangles))
            meshes.push_back(parse_triangles(text));
    if (sizes.empty()) sizes = {{1280, 720}};
    if (meshes.empty()) meshes = {4096, 102400};
    std::vector<FrameCase> cases;
    for (const Size& size : sizes)
        for (const int triangles : meshes) cases.push_back({triangles, size.width, size.height});
    return cases;
}

std::vector<Technique> techniques_of(const BenchFlags& flags) {
    if (!flags.methods) return {techniques().begin(), techniques().end()};
    std::vector<Technique> list;
    for (const std::string& name : split(*flags.methods))
        list.push_back(technique_named(name, "--methods"));
    return list;
}

void run_bench(const BenchFlags& flags, const Session& session) {
    FrameCostRequest request = default_frame_request(flags.quick);
    request.cases = cases_of(flags);
    request.techniques = techniques_of(flags);
    if (flags.pairs > 0) request.rounds = flags.pairs;
    request.gl_device = flags.gl_device;
    if (flags.output && flags.output->empty())
        throw UsageError("--output", "", "a name that ends in .json", "none");
    request.output = flags.output.value_or("");
    request.command = session.command_line();
    keep_freed_memory();  // must precede the first context
    const FrameCostReport report = bench_frame(request, session.progress());
    for (const std::string& warning : report.cost.warnings)
        std::fprintf(stderr, "burnish: warning: %s\n", warning.c_str());
    std::string text;
    if (report.written.empty()) text = frame_cost_markdown(report.cost);
    for (const auto& path : report.written) text += path.string() + '\n';
    print(text);
}

void add_frame_command(CLI::App& bench, Session& session) {
    CLI::App* command = bench.add_subcommand(
        "frame", "Time a frame by technique, mesh and picture size, beside the papers' figures");
    const auto flags = std::make_shared<BenchFlags>();
    command->add_option("-o,--output", flags->output, "OUT.json; OUT.md and OUT.svg lie beside it")
        ->type_name("FILE");
    command
        ->add_option("--size", flags->sizes,
                     "picture sizes, WIDTHxHEIGHT,... (default 1280x720, and 102 k triangles at "
                     "1920x1080 and 3840x2160)")
        ->type_name("LIST");
    command
        ->add_option("--triangles", flags->triangles,
                     "triangles of the torus, such as 4k,102400,1M (default 4096, 16384, 102400, "
                     "400000, 1000000)")
        ->type_name("LIST");
    command->add_option("--methods", flags->methods, "techniques (default: all of those below)")
        ->type_name("LIST");
    add_integer(*command, "--pairs", flags->pairs, {3, 1000},
                "interleaved rounds, default 15, with --quick 7")
        ->type_name("COUNT");
    command->add_flag("--quick", flags->quick,
                      "4,096 and 102,400 triangles at 1280x720, short samples");
    add_gl_device(*command, flags->gl_device);
    command->footer(kBenchFooter);
    command->callback([flags, &session] { run_bench(*flags, session); });
}

}  // namespace

void add_bench_command(CLI::App& parent, Session& session) {
    CLI::App* bench = parent.add_subcommand("bench", "Measure what frames cost on this machine");
    require_command(*bench);
    add_frame_command(*bench, session);
}

}  // namespace burnish::cli
