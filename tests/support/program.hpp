// Runs the program under test as users do, with files in a folder of its own.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace burnish::test {

// A unique folder, removed with its contents by the destructor.
class Folder {
  public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& contents) const;  // its path
    std::vector<std::string> names() const;  // sorted; includes remaining temporary files

  private:
    std::filesystem::path path_;
};

std::string contents_of(const std::string& path);

struct Surroundings {
    std::string input{};                     // contents of standard input
    std::string output_file{};               // file of standard output; empty: it is captured
    rlim_t file_size_limit = RLIM_INFINITY;  // bytes
};

struct Outcome {
    int exit_code = -1;  // -1: ended by a signal
    std::string output;
    std::string complaint;
};

Outcome run_burnish(const std::vector<std::string>& arguments, const Surroundings& around = {});

// A running program; the test holds the pipes of its standard input and output.
class RunningProgram {
  public:
    explicit RunningProgram(const std::vector<std::string>& arguments);
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;
    ~RunningProgram();

    void give(const std::string& text);
    void end_input();
    void close_output();  // closes the reading end of its output
    void send_signal(int number);
    Outcome wait();  // `output` is empty

  private:
    pid_t process_ = -1;
    int input_ = -1;
    int output_ = -1;
    Folder folder_;
};

// Expects a failure as documented for users: the exit code, and one line that starts with
// "burnish: " and contains every one of `parts`.
void expect_complaint(const Outcome& outcome, int exit_code, const std::vector<std::string>& parts);

// The one-line message of the Error that `work` throws. Needs no program, for the many ways in
// which a file can be wrong.
std::string refusal_of(const std::function<void()>& work);
void expect_parts(const std::string& line, const std::vector<std::string>& parts);

}  // namespace burnish::test
