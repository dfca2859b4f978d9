#include "core/run_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>
#include <vector>

#include "burnish/error.hpp"
#include "core/files.hpp"

extern char** environ;

namespace burnish {
namespace {

constexpr std::size_t kMostMessageBytes = std::size_t{64} << 10;
constexpr int kWait_ms = 100;

class Pipe {
  public:
    explicit Pipe(const std::string& program) {
        if (::pipe2(ends_.data(), O_CLOEXEC) != 0)
            throw Error(program, "", "a pipe to it", reason_of(errno));
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        close_end(0);
        close_end(1);
    }

    int reading_end() const { return ends_[0]; }
    int writing_end() const { return ends_[1]; }
    void close_writing_end() { close_end(1); }

    // What is there now; closes the reading end where nothing will come any more.
    std::string_view read() {
        const ssize_t count = ::read(ends_[0], buffer_.data(), buffer_.size());
        if (count > 0) return {buffer_.data(), static_cast<std::size_t>(count)};
        if (count == 0 || errno != EINTR) close_end(0);
        return {};
    }

  private:
    void close_end(std::size_t end) {
        if (ends_[end] >= 0) ::close(std::exchange(ends_[end], -1));
    }

    std::array<int, 2> ends_{-1, -1};
    std::array<char, 4096> buffer_{};
};

// A program that runs; the destructor ends it.
class Child {
  public:
    explicit Child(pid_t id) : id_(id) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (id_ < 0) return;
        ::kill(id_, SIGKILL);
        wait();
    }

    int wait() {
        int status = 0;
        const pid_t id = std::exchange(id_, -1);
        while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
        }
        return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    }

  private:
    pid_t id_;
};

// 0 or the number of the error.
int spawn(std::span<const std::string> words, const Pipe& output, const Pipe& messages, pid_t& id) {
    std::vector<std::string> copies(words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, output.writing_end(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, messages.writing_end(), STDERR_FILENO);
    const int error = ::posix_spawnp(&id, arguments[0], &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

}  // namespace

std::optional<ProgramResult> run_program(std::span<const std::string> words,
                                         const std::function<void(std::string_view)>& on_output) {
    Pipe output(words[0]), errors(words[0]);
    pid_t id = -1;
    const int failed = spawn(words, output, errors, id);
    if (failed == ENOENT) return std::nullopt;
    if (failed != 0) throw Error(words[0], "", "a program that starts", reason_of(failed));
    Child child(id);
    output.close_writing_end();
    errors.close_writing_end();
    ProgramResult result;
    // poll() passes over descriptors that are negative: the ends that were closed.
    while (output.reading_end() >= 0 || errors.reading_end() >= 0) {
        std::array<pollfd, 2> wanted{
            {{output.reading_end(), POLLIN, 0}, {errors.reading_end(), POLLIN, 0}}};
        const int ready = ::poll(wanted.data(), wanted.size(), kWait_ms);
        std::string_view printed;
        if (ready > 0 && wanted[0].revents != 0) printed = output.read();
        if (on_output) on_output(printed);
        if (ready > 0 && wanted[1].revents != 0) {
            const std::string_view more = errors.read();
            result.messages +=
                more.substr(0, std::min(more.size(), kMostMessageBytes - result.messages.size()));
        }
    }
    result.exit_code = child.wait();
    return result;
}

}  // namespace burnish
