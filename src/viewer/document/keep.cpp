#include "viewer/document/keep.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/json_text.hpp"
#include "viewer/document/file_names.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/document/viewer_section.hpp"

namespace burnish::viewer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFile = "view.json";
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 20;
constexpr std::uintmax_t kMostSceneBytes = std::uintmax_t{64} << 20;
constexpr int kLeastWindow = 320, kLargestWindow = 16384, kFarthest = 1000000;
constexpr std::size_t kMostPanels = 100;

// --- view.json ----------------------------------------------------------------------------------

int whole(const JsonPlace& place, int low, int high) {
    const double number = place.number(low, high);
    return static_cast<int>(number);
}

bool yes_or_no(const JsonPlace& place) {
    if (!place.value().is_boolean()) place.fail("true or false");
    return place.value().get<bool>();
}

Remembered read_remembered(const JsonPlace& root) {
    root.require_object();
    Remembered out;
    if (root.has("width")) out.width = whole(root.at("width"), kLeastWindow, kLargestWindow);
    if (root.has("height")) out.height = whole(root.at("height"), kLeastWindow, kLargestWindow);
    if (root.has("x") && root.has("y")) {
        out.x = whole(root.at("x"), -kFarthest, kFarthest);
        out.y = whole(root.at("y"), -kFarthest, kFarthest);
    }
    if (root.has("maximized")) out.maximized = yes_or_no(root.at("maximized"));
    if (root.has("panels")) {
        const JsonPlace panels = root.at("panels");
        panels.require_object();
        for (const std::string& name : panels.keys())
            if (out.panels.size() < kMostPanels) out.panels[name] = yes_or_no(panels.at(name));
    }
    if (root.has("navigation"))
        out.navigation =
            static_cast<Navigation>(index_of_name(navigation_names(), root.at("navigation").text(),
                                                  "navigation", root.file() + ": navigation"));
    if (root.has("touchpad")) out.touchpad = yes_or_no(root.at("touchpad"));
    if (root.has("recent")) {
        const JsonPlace recent = root.at("recent");
        recent.require_array(1000);
        for (std::size_t i = 0; i < std::min(recent.size(), kMostRecent); ++i)
            out.recent.push_back(recent.at(i).text());
    }
    return out;
}

// --- autosave -----------------------------------------------------------------------------------

constexpr std::string_view kPrefix = "autosave-", kEnding = ".json";

std::string host_name() {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
    std::string host = name.data();
    // Only what is plain in a file name.
    std::erase_if(host, [](char c) {
        return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                 c == '.');
    });
    return host.empty() ? "host" : host;
}

// When the process started, in ticks since the machine did; 0 where the system does not tell. A number
// of a process that ended may be that of another one by now.
long long start_of(long long process) {
    std::ifstream file(fmt::format("/proc/{}/stat", process));
    std::string text;
    std::getline(file, text);
    // The name of the program is in brackets, and may have blanks and brackets in it.
    const std::size_t name_end = text.rfind(')');
    if (name_end == text.npos) return 0;
    std::size_t at = name_end + 1;
    // The start is field 22; the one behind the name is field 3.
    for (int field = 3; field <= 22; ++field) {
        at = text.find_first_not_of(' ', at);
        if (at == text.npos) return 0;
        if (field < 22) at = std::min(text.find(' ', at), text.size());
    }
    long long start = 0;
    std::from_chars(text.data() + at, text.data() + text.size(), start);
    return start;
}

struct Process {
    long long number = 0, start = 0;
};

bool lives(const Process& process) {
    const bool there = ::kill(static_cast<pid_t>(process.number), 0) == 0 || errno == EPERM;
    return there && (process.start == 0 || start_of(process.number) == process.start);
}

// The process of "autosave-<host>-<pid>-<start>.json" of this host; none for other names.
std::optional<Process> process_of(const std::string& file_name) {
    const std::string head = fmt::format("{}{}-", kPrefix, host_name());
    if (!file_name.starts_with(head) || !file_name.ends_with(kEnding)) return std::nullopt;
    const char* const end = file_name.data() + file_name.size() - kEnding.size();
    Process process;
    const auto [dash, error] = std::from_chars(file_name.data() + head.size(), end, process.number);
    if (error != std::errc() || dash == end || *dash != '-' || process.number <= 0)
        return std::nullopt;
    const auto [stop, second] = std::from_chars(dash + 1, end, process.start);
    if (second != std::errc() || stop != end) return std::nullopt;
    return process;
}

// What an autosaved scene was; "" where the file does not say.
std::string scene_of(const fs::path& file) {
    try {
        const nlohmann::json json =
            parse_json(file.string(), read_text_file(file, kMostSceneBytes));
        return json.at("viewer").at("scene").get<std::string>();
    } catch (const std::exception&) {
        return {};
    }
}

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(folder.string(), "", "a folder for the viewer's state",
                    one_line(error.message()));
}

}  // namespace

void add_recent(Remembered& remembered, const std::string& path) {
    const std::string name = absolute_name(path);
    std::erase(remembered.recent, name);
    remembered.recent.insert(remembered.recent.begin(), name);
    if (remembered.recent.size() > kMostRecent) remembered.recent.resize(kMostRecent);
}

fs::path state_folder() {
    // The XDG base directory specification passes over paths that are not absolute.
    const char* state = std::getenv("XDG_STATE_HOME");
    if (state != nullptr && fs::path(state).is_absolute()) return fs::path(state) / "burnish";
    const char* home = std::getenv("HOME");
    if (home == nullptr || *home == '\0') return {};
    return fs::path(home) / ".local/state/burnish";
}

Remembered load_remembered(const fs::path& folder, std::vector<std::string>& warnings) {
    std::error_code error;
    const fs::path file = folder / kFile;
    if (folder.empty() || !fs::exists(file, error)) return {};
    try {
        const nlohmann::json json = parse_json(file.string(), read_text_file(file, kMostBytes));
        const std::string name = file.string();
        return read_remembered(JsonPlace(name, json));
    } catch (const std::exception& broken) {
        warnings.push_back(one_line(broken.what()) + ": the window has its first state");
        return {};
    }
}

void save_remembered(const fs::path& folder, const Remembered& remembered) {
    make_folder(folder);
    nlohmann::ordered_json root;
    root["width"] = remembered.width;
    root["height"] = remembered.height;
    if (remembered.x && remembered.y) {
        root["x"] = *remembered.x;
        root["y"] = *remembered.y;
    }
    root["maximized"] = remembered.maximized;
    root["panels"] = remembered.panels;
    root["navigation"] = navigation_names()[static_cast<std::size_t>(remembered.navigation)];
    root["touchpad"] = remembered.touchpad;
    root["recent"] = remembered.recent;
    write_text_file(folder / kFile,
                    root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

fs::path autosave_path(const fs::path& folder) {
    const long long process = ::getpid();
    return folder /
           fmt::format("{}{}-{}-{}{}", kPrefix, host_name(), process, start_of(process), kEnding);
}

void autosave(const fs::path& folder, const Document& document, const Stage& stage,
              const std::string& scene) {
    make_folder(folder);
    save_scene(document, stage, autosave_path(folder), {}, scene);
}

SceneName scene_name(const Document& document, const Stage& stage) {
    try {
        const std::string of = read_viewer_section(stage.file.viewer, document.input).scene;
        if (!of.empty()) return {of, true};
    } catch (const std::exception&) {
        // A broken section is said where the file is opened.
    }
    return {document.input, false};
}

std::string proposed_scene_file(const SceneName& scene) {
    if (scene.path.empty() || is_builtin(scene.path)) return "scene.json";
    return fs::path(scene.path).replace_extension(".json").string();
}

std::string text_of_offer(const LeftBehind& left) {
    const auto since = left.written - fs::file_time_type::clock::now();
    const std::time_t written = std::chrono::system_clock::to_time_t(
        std::chrono::system_clock::now() +
        std::chrono::duration_cast<std::chrono::system_clock::duration>(since));
    std::tm local{};
    ::localtime_r(&written, &local);
    std::array<char, 32> when{};
    std::strftime(when.data(), when.size(), "%Y-%m-%d %H:%M", &local);
    const std::string scene =
        left.scene.empty() ? std::string() : "The scene: " + one_line(left.scene) + "\n";
    return scene + "Kept: " + when.data();
}

void remove_autosave(const fs::path& folder) {
    std::error_code error;
    if (!folder.empty()) fs::remove(autosave_path(folder), error);
}

std::vector<LeftBehind> autosaves_left_behind(const fs::path& folder) {
    std::vector<LeftBehind> all;
    std::error_code error;
    if (folder.empty()) return all;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::optional<Process> process = process_of(entry->path().filename().string());
        std::error_code unreadable;
        if (!process || lives(*process) || !entry->is_regular_file(unreadable)) continue;
        const fs::file_time_type written = entry->last_write_time(unreadable);
        if (!unreadable) all.push_back({entry->path(), written, scene_of(entry->path())});
    }
    std::sort(all.begin(), all.end(),
              [](const LeftBehind& a, const LeftBehind& b) { return a.written > b.written; });
    return all;
}

}  // namespace burnish::viewer
