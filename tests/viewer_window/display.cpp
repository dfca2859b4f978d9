#include "viewer_window/display.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

#include "burnish/image_io.hpp"
#include "support/glb_writer.hpp"
#include "support/paths.hpp"

namespace burnish::test {
namespace {

using Clock = std::chrono::steady_clock;

// No run of these tests takes longer, not even under the sanitizers.
constexpr std::chrono::seconds kLongestRun(100);
constexpr int kLongestStart_ms = 10000;  // of Xvfb

class Xvfb {
  public:
    Xvfb() {
        int number[2];
        if (::pipe(number) != 0) return;
        process_ = ::fork();
        if (process_ == 0) {
            ::close(number[0]);
            ::prctl(PR_SET_PDEATHSIG, SIGKILL);
            const int nowhere = ::open("/dev/null", O_RDWR);
            ::dup2(nowhere, STDERR_FILENO);
            const std::string descriptor = std::to_string(number[1]);
            ::execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0",
                     "1280x1024x24", "-nolisten", "tcp", static_cast<char*>(nullptr));
            ::_exit(127);
        }
        ::close(number[1]);
        std::string text;
        pollfd wanted{number[0], POLLIN, 0};
        char byte = 0;
        while (::poll(&wanted, 1, kLongestStart_ms) == 1 && ::read(number[0], &byte, 1) == 1 &&
               byte != '\n')
            text += byte;
        ::close(number[0]);
        if (byte == '\n' && !text.empty()) display_ = ":" + text;
    }
    ~Xvfb() {
        if (process_ <= 0) return;
        ::kill(process_, SIGTERM);
        ::waitpid(process_, nullptr, 0);
    }
    Xvfb(const Xvfb&) = delete;
    Xvfb& operator=(const Xvfb&) = delete;
    const std::string& display() const { return display_; }

  private:
    pid_t process_ = -1;
    std::string display_;
};

std::string viewer_path() {
    return (build_folder() / "bin" / "burnish-view").string();
}

// Starts the viewer with its standard streams in files.
pid_t start_viewer(const std::vector<std::string>& arguments, const std::string& display,
                   const std::string& output, const std::string& complaint) {
    const std::string program = viewer_path();
    const pid_t process = ::fork();
    if (process != 0) return process;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (display.empty())
        ::unsetenv("DISPLAY");
    else
        ::setenv("DISPLAY", display.c_str(), 1);
    ::unsetenv("WAYLAND_DISPLAY");
    ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open(complaint.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments)
        words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    ::execv(program.c_str(), words.data());
    ::_exit(127);
}

// The exit code; -1 for a process that a signal has ended, or that took too long.
int wait_for(pid_t process) {
    const Clock::time_point start = Clock::now();
    int status = 0;
    while (::waitpid(process, &status, WNOHANG) == 0) {
        if (Clock::now() - start > kLongestRun) {
            ::kill(process, SIGKILL);
            ::waitpid(process, &status, 0);
            return -1;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// A sphere of radius 0.5 m around (x, 0, 0).
GlbPrimitive sphere_at(float x) {
    constexpr unsigned kRings = 24, kSides = 48;
    GlbPrimitive sphere;
    for (unsigned r = 0; r <= kRings; ++r)
        for (unsigned s = 0; s <= kSides; ++s) {
            const float polar = std::numbers::pi_v<float> * static_cast<float>(r) / kRings;
            const float turn = 2 * std::numbers::pi_v<float> * static_cast<float>(s) / kSides;
            const glm::vec3 n(std::sin(polar) * std::sin(turn), std::cos(polar),
                              std::sin(polar) * std::cos(turn));
            sphere.positions.push_back(0.5f * n + glm::vec3(x, 0, 0));
            sphere.normals.push_back(n);
            sphere.texcoord0.emplace_back(static_cast<float>(s) / kSides,
                                          static_cast<float>(r) / kRings);
        }
    for (unsigned r = 0; r < kRings; ++r)
        for (unsigned s = 0; s < kSides; ++s) {
            const unsigned a = r * (kSides + 1) + s, b = a + kSides + 1;
            for (const unsigned i : {a, b, a + 1, a + 1, b, b + 1}) sphere.indices.push_back(i);
        }
    return sphere;
}

}  // namespace

const std::string& virtual_display() {
    static const Xvfb xvfb;
    return xvfb.display();
}

void ViewerWindow::SetUp() {
    if (virtual_display().empty())
        GTEST_SKIP()
            << "SKIPPED, nothing was tested: Xvfb is missing or does not start (the package "
               "xvfb has it)";
}

Outcome ViewerWindow::run_with(const std::vector<std::string>& arguments,
                               const std::string& display) {
    const std::string output = path("stdout.txt"), complaint = path("stderr.txt");
    const int code = wait_for(start_viewer(arguments, display, output, complaint));
    return {code, contents_of(output), contents_of(complaint)};
}

Outcome ViewerWindow::run(const std::string& script, std::vector<std::string> arguments,
                          const std::string& name) {
    std::vector<std::string> words = {"--size", "640x480", "--ui-scale", "1"};
    if (std::find(arguments.begin(), arguments.end(), "--state") == arguments.end())
        words.insert(words.end(), {"--state", "none"});
    words.insert(words.end(), {"--script", folder_.write(name, script)});
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_with(words, virtual_display());
}

std::map<std::string, std::string> ViewerWindow::play(const std::string& script,
                                                      std::vector<std::string> arguments) {
    const Outcome outcome = run(script, std::move(arguments));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.complaint, "");
    std::map<std::string, std::string> logged;
    std::istringstream lines(outcome.output);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t blank = line.find(' ');
        if (blank != std::string::npos) logged[line.substr(0, blank)] = line.substr(blank + 1);
    }
    return logged;
}

std::string ViewerWindow::two_materials(const std::string& name,
                                        const std::vector<std::byte>& texture) {
    GlbWriter writer;
    GlbPrimitive left = sphere_at(-0.6f), right = sphere_at(0.6f);
    nlohmann::json surface = {{"baseColorFactor", {0.9, 0.3, 0.2, 1.0}}, {"roughnessFactor", 0.4}};
    if (!texture.empty()) surface["baseColorTexture"] = {{"index", writer.add_png(texture)}};
    left.material = writer.add_material({{"name", "left"}, {"pbrMetallicRoughness", surface}});
    right.material = writer.add_material(
        {{"name", "right"},
         {"pbrMetallicRoughness", {{"metallicFactor", 1.0}, {"roughnessFactor", 0.35}}}});
    writer.add_node(writer.add_mesh(left));
    writer.add_node(writer.add_mesh(right));
    const std::vector<std::byte> glb = writer.glb();
    return folder_.write(name, std::string(reinterpret_cast<const char*>(glb.data()), glb.size()));
}

Image ViewerWindow::picture(const std::string& name) const {
    return read_image(path(name), {.as_data = true});  // levels are those of the display
}

RunningViewer::RunningViewer(const std::vector<std::string>& arguments)
    : process_(start_viewer(arguments, virtual_display(), "/dev/null", "/dev/null")) {}

void RunningViewer::kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(std::exchange(process_, -1), nullptr, 0);
}

double levels_between(const Image& a, const Image& b, int rows) {
    if (a.width != b.width || a.height != b.height) return 1e9;
    double most = 0;
    for (int y = 0; y < (rows == 0 ? a.height : rows); ++y)
        for (int x = 0; x < a.width; ++x)
            for (int c = 0; c < 3; ++c)
                most = std::max(most, 255.0 * std::abs(static_cast<double>(a.at(x, y)[c]) -
                                                       static_cast<double>(b.at(x, y)[c])));
    return most;
}

}  // namespace burnish::test
