// Runs burnish-view on a virtual display (Xvfb), with scripts that the tests write.
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/image.hpp"
#include "support/program.hpp"

namespace burnish::test {

// The virtual display of this test program, started at the first call and ended with the program: ":99".
// Empty where Xvfb is missing or does not start.
const std::string& virtual_display();

// A test of the window: skips where there is no virtual display.
class ViewerWindow : public testing::Test {
  protected:
    void SetUp() override;

    // Runs the script in a window of 640x480, with `arguments` behind --script. `name` is that of the
    // script's file.
    Outcome run(const std::string& script, std::vector<std::string> arguments = {},
                const std::string& name = "script.txt");
    // The same, and expects that the script reaches its end without a word of complaint. Returns what
    // it has logged, by name; of a name that is logged twice, the last.
    std::map<std::string, std::string> play(const std::string& script,
                                            std::vector<std::string> arguments = {});
    // As `run`, with nothing but the given arguments; `display` may be empty: none.
    Outcome run_with(const std::vector<std::string>& arguments, const std::string& display);

    std::string path(const std::string& name) const { return folder_.path(name); }
    // Two spheres side by side in one glTF file, of the materials "left" and "right"; the texture of
    // the left one is `texture`, if one is given.
    std::string two_materials(const std::string& name, const std::vector<std::byte>& texture = {});
    Image picture(const std::string& name) const;

    Folder folder_;
};

// A running viewer. Killed by the destructor.
class RunningViewer {
  public:
    explicit RunningViewer(const std::vector<std::string>& arguments);
    ~RunningViewer() { kill(); }
    RunningViewer(const RunningViewer&) = delete;
    RunningViewer& operator=(const RunningViewer&) = delete;
    void kill();  // by SIGKILL

  private:
    pid_t process_ = -1;
};

// Largest difference of two pictures of one size in the colors of the first `rows` rows (0: all), in
// parts of 255; 1e9 for different sizes.
double levels_between(const Image& a, const Image& b, int rows = 0);

}  // namespace burnish::test
