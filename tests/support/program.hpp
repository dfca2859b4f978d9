// Runs the program under test as a person would, with files in a folder of its own.
#pragma once

#include <sys/resource.h>
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace burnish::test {

// A unique folder, removed with everything in it.
class Folder {
  public:
    Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder();

    std::string path(const std::string& name) const { return (path_ / name).string(); }
    std::string write(const std::string& name, const std::string& contents) const;  // its path
    std::vector<std::string> names() const;  // sorted; left-over temporary files show up here

  private:
    std::filesystem::path path_;
};

std::string contents_of(const std::string& path);

struct Surroundings {
    std::string input{};                     // what standard input holds
    std::string output_file{};               // where standard output goes; empty: it is captured
    rlim_t file_size_limit = RLIM_INFINITY;  // bytes
};

struct Outcome {
    int exit_code = -1;  // -1: ended by a signal
    std::string output;
    std::string complaint;
};

Outcome run_burnish(const std::vector<std::string>& arguments, const Surroundings& around = {});

// A running program whose standard input and output are pipes that the test holds.
class RunningProgram {
  public:
    explicit RunningProgram(const std::vector<std::string>& arguments);
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;
    ~RunningProgram();

    void give(const std::string& text);
    void end_input();
    void close_output();  // the reader of its output goes away
    void send_signal(int number);
    Outcome wait();  // `output` stays empty

  private:
    pid_t process_ = -1;
    int input_ = -1;
    int output_ = -1;
    Folder folder_;
};

// A failure as users are promised it: the exit code, and one line that starts with "burnish: " and
// has every one of `parts` in it.
void expect_complaint(const Outcome& outcome, int exit_code, const std::vector<std::string>& parts);

// The one line of the Error that `work` throws, without starting a program: for the many ways in
// which a file can be wrong.
std::string refusal_of(const std::function<void()>& work);
void expect_parts(const std::string& line, const std::vector<std::string>& parts);

}  // namespace burnish::test
