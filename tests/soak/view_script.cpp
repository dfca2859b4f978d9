// Writes a script of random actions for `burnish view --script`, for scripts/soak_view.sh:
//   view_script SEED SECONDS FOLDER
// Scenes are saved in FOLDER. The script ends when the viewer has run for SECONDS.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "burnish/parameters.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {
namespace {

// More than any machine does; the script ends by its clock.
constexpr double kActionsPerSecond = 40;
constexpr int kActionsPerLog = 40;

class ScriptWriter {
  public:
    ScriptWriter(unsigned seed, double seconds, std::string folder)
        : random_(seed), seconds_(seconds), folder_(std::move(folder)) {}

    void write() {
        quick_again();
        line("try wait rest");
        line("try log memory_mb");
        const int actions = static_cast<int>(seconds_ * kActionsPerSecond);
        for (int i = 1; i <= actions; ++i) {
            action();
            if (i % kActionsPerLog != 0) continue;
            quick_again();
            line("try log memory_mb undo_count");
            line(fmt::format("quit {}", seconds_));
        }
    }

  private:
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    template <typename Names>
    std::string one_of(const Names& names) {
        return std::string(names[below(std::size(names))]);
    }
    static void line(const std::string& text) { std::printf("%s\n", text.c_str()); }

    // Undo brings back values that take long.
    void quick_again() {
        line("try set samples 2");
        line("try set image_light_samples 2");
        line("panel keys off");
        line("try wait 2");
    }

    // Ends of ranges are where things go wrong.
    double number(const Parameter& p) {
        if (below(8) == 0) return below(2) == 0 ? p.low : p.high;
        return between(p.low, p.high);
    }

    std::string value_of(const Parameter& p) {
        switch (p.kind) {
            case ParameterKind::real:
                return fmt::format("{:.6g}", number(p));
            case ParameterKind::integer:
                return fmt::format("{:.0f}", number(p));
            case ParameterKind::boolean:
                return below(2) == 0 ? "true" : "false";
            case ParameterKind::choice:
                return one_of(p.choices);
            case ParameterKind::color:
            case ParameterKind::vector:
                return fmt::format("{:.5g},{:.5g},{:.5g}", number(p), number(p), number(p));
            case ParameterKind::text:
                break;
        }
        return "none";
    }

    // Pictures of 16384 pixels and millions of triangles are no random edits.
    static bool takes_long(const Parameter& p) {
        return p.name == "width" || p.name == "height" || p.name == "samples" ||
               p.name == "triangles" || p.name == "image_light_samples";
    }

    void parameter() {
        const Parameter& p = parameter_table()[below(parameter_table().size())];
        if (takes_long(p)) return;
        if (p.kind == ParameterKind::text) {
            static constexpr std::string_view kSet[] = {"set normal_map builtin:bumps",
                                                        "unset normal_map", "set weave plain",
                                                        "set weave twill", "unset weave"};
            return line("try " + one_of(kSet));
        }
        const bool own = p.group == ParameterGroup::material && below(4) == 0;
        const std::string value = below(5) == 0 ? "" : " " + value_of(p);
        line(fmt::format("try {} {}{}{}", value.empty() ? "unset" : "set", p.name, value,
                         own ? " #0" : ""));
    }

    void drag() {
        static constexpr std::string_view kKinds[] = {"orbit", "pan", "zoom", "light",
                                                      "environment"};
        line(fmt::format("try drag {} {:.0f} {:.0f} {}", one_of(kKinds), between(-150, 150),
                         between(-80, 80), 1 + below(8)));
    }

    void open() {
        static constexpr std::string_view kInputs[] = {"builtin:sphere", "builtin:torus",
                                                       "builtin:cylinder", "builtin:plane",
                                                       "builtin:drape"};
        if (below(3) == 0) return line(fmt::format("try open {}", scene_file()));
        line("try open " + one_of(kInputs));
    }

    std::string scene_file() { return fmt::format("{}/scene{}.json", folder_, below(4)); }

    void environment() {
        static constexpr std::string_view kNames[] = {"builtin:studio", "builtin:white",
                                                      "builtin:black", "none"};
        line("try environment " + one_of(kNames));
    }

    void light() {
        if (below(4) == 0) return line("try light none");
        line(fmt::format("try light {:.1f},{:.1f},{:.2f}", between(-180, 180), between(-90, 90),
                         between(0, 5)));
    }

    void compare() {
        static constexpr std::string_view kWays[] = {
            "off",
            "off",
            "split normal-map follow-grain",
            "split normal-map rotate-approx follow-grain deform-smooth",
            "blink",
            "difference deform-smooth follow-grain",
            "flip"};
        line("try compare " + one_of(kWays));
    }

    void panel() {
        static constexpr std::string_view kNames[] = {"parameters", "scene",    "compare",
                                                      "inspector",  "messages", "keys",
                                                      "costs",      "generator"};
        line(fmt::format("try panel {} {}", one_of(kNames), below(3) == 0 ? "off" : "on"));
    }

    void key() {
        static constexpr std::string_view kKeys[] = {
            "f", "home", "m", "c", "v", "g", "[", "]", "tab", "?", "ctrl+shift+c", "ctrl+z"};
        line("try key " + one_of(kKeys));
    }

    void place() {
        const double x = between(0, 480), y = between(20, 340);
        static constexpr std::string_view kHow[] = {
            "try pick {:.0f} {:.0f}", "try click {:.0f} {:.0f}", "try click {:.0f} {:.0f} shift",
            "try move {:.0f} {:.0f}"};
        line(fmt::format(fmt::runtime(one_of(kHow)), x, y));
    }

    void undo() { line(fmt::format("try {} {}", below(2) == 0 ? "undo" : "redo", 1 + below(12))); }

    void action() {
        const std::size_t kind = below(100);
        if (kind < 35) return parameter();
        if (kind < 50) return drag();
        if (kind < 60) return place();
        if (kind < 68) return undo();
        if (kind < 72) return open();
        if (kind < 75) return environment();
        if (kind < 79) return light();
        if (kind < 83) return compare();
        if (kind < 87) return line("try view " + one_of(surface_view_names()));
        if (kind < 90) return panel();
        if (kind < 93) return key();
        if (kind < 94)
            return line(fmt::format("try resize {}x{}", 320 + below(400), 240 + below(300)));
        if (kind < 96) return line(fmt::format("try save scene {}", scene_file()));
        if (kind < 97) return line(fmt::format("try save picture {}/p.png 64x48", folder_));
        if (kind < 98) return line("try wait rest");
        line("try wait 2");
    }

    std::mt19937_64 random_;
    double seconds_;
    std::string folder_;
};

}  // namespace
}  // namespace burnish

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: view_script SEED SECONDS FOLDER\n");
        return 2;
    }
    burnish::ScriptWriter(static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)),
                          std::strtod(argv[2], nullptr), argv[3])
        .write();
    return 0;
}
