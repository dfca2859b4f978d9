#include "program.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "burnish/error.hpp"
#include "support/paths.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

struct Descriptors {
    int input, output, complaint;
};

// Turns the child into burnish with the standard streams `streams`; never returns.
[[noreturn]] void become_burnish(const std::vector<std::string>& arguments,
                                 const Descriptors& streams, rlim_t file_size_limit) {
    const rlimit limit{file_size_limit, file_size_limit};
    if (file_size_limit != RLIM_INFINITY) ::setrlimit(RLIMIT_FSIZE, &limit);
    ::dup2(streams.input, STDIN_FILENO);
    ::dup2(streams.output, STDOUT_FILENO);
    ::dup2(streams.complaint, STDERR_FILENO);
    std::vector<char*> words{const_cast<char*>(test::program_path())};
    for (const std::string& argument : arguments) {
        words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    ::execv(test::program_path(), words.data());
    ::_exit(127);
}

int open_or_throw(const std::string& path, int flags) {
    const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC, 0600);
    if (descriptor < 0) throw std::runtime_error("cannot open " + path);
    return descriptor;
}

int exit_code_of(pid_t process) {
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

Folder::Folder() {
    std::string name = (fs::temp_directory_path() / "burnish-cli-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

std::string Folder::write(const std::string& name, const std::string& contents) const {
    std::ofstream(path(name), std::ios::binary) << contents;
    return path(name);
}

std::vector<std::string> Folder::names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(path_)) {
        names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::string contents_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Outcome run_burnish(const std::vector<std::string>& arguments, const Surroundings& around) {
    const Folder folder;
    const std::string input = folder.write("stdin", around.input);
    const bool capture = around.output_file.empty();
    const std::string output = capture ? folder.path("stdout") : around.output_file;
    const Descriptors streams{open_or_throw(input, O_RDONLY),
                              open_or_throw(output, O_WRONLY | O_CREAT),
                              open_or_throw(folder.path("stderr"), O_WRONLY | O_CREAT)};
    const pid_t process = ::fork();
    if (process == 0) become_burnish(arguments, streams, around.file_size_limit);
    for (const int descriptor : {streams.input, streams.output, streams.complaint}) {
        ::close(descriptor);
    }
    const int exit_code = exit_code_of(process);
    return {exit_code, capture ? contents_of(output) : "", contents_of(folder.path("stderr"))};
}

RunningProgram::RunningProgram(const std::vector<std::string>& arguments) {
    int input[2], output[2];
    if (::pipe2(input, O_CLOEXEC) != 0 || ::pipe2(output, O_CLOEXEC) != 0) {
        throw std::runtime_error("no pipe");
    }
    const Descriptors streams{input[0], output[1],
                              open_or_throw(folder_.path("stderr"), O_WRONLY | O_CREAT)};
    process_ = ::fork();
    if (process_ == 0) become_burnish(arguments, streams, RLIM_INFINITY);
    for (const int descriptor : {streams.input, streams.output, streams.complaint}) {
        ::close(descriptor);
    }
    input_ = input[1];
    output_ = output[0];
}

RunningProgram::~RunningProgram() {
    end_input();
    close_output();
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    exit_code_of(process_);
}

void RunningProgram::give(const std::string& text) {
    EXPECT_EQ(::write(input_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
}

void RunningProgram::end_input() {
    if (input_ >= 0) ::close(std::exchange(input_, -1));
}

void RunningProgram::close_output() {
    if (output_ >= 0) ::close(std::exchange(output_, -1));
}

void RunningProgram::send_signal(int number) {
    ::kill(process_, number);
}

Outcome RunningProgram::wait() {
    const int exit_code = exit_code_of(std::exchange(process_, -1));
    return {exit_code, "", contents_of(folder_.path("stderr"))};
}

void expect_complaint(const Outcome& outcome, int exit_code,
                      const std::vector<std::string>& parts) {
    const std::string& line = outcome.complaint;
    EXPECT_EQ(outcome.exit_code, exit_code) << line;
    EXPECT_TRUE(line.starts_with("burnish: ")) << line;
    EXPECT_TRUE(line.ends_with("\n")) << line;
    EXPECT_EQ(std::count_if(line.begin(), line.end(),
                            [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
              1)
        << line;
    expect_parts(line, parts);
}

std::string refusal_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const UsageError& error) {
        ADD_FAILURE() << "a wrong file is no wrong command: " << error.what();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "nothing was refused";
    return "";
}

void expect_parts(const std::string& line, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) {
        EXPECT_NE(line.find(part), std::string::npos) << "no '" << part << "' in: " << line;
    }
}

}  // namespace burnish::test
