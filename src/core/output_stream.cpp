#include "core/output_stream.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "burnish/error.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

[[noreturn]] void throw_unwritable(const std::string& name) {
    throw Error(name, "", "a file that can be written", reason_of(errno));
}

}  // namespace

OutputStream::OutputStream(int descriptor, std::string name, Progress cancellable)
    : descriptor_(descriptor), name_(std::move(name)), cancellable_(std::move(cancellable)) {
    if (descriptor_ < 0) throw_unwritable(name_);
}

OutputStream::OutputStream(const std::filesystem::path& path, std::string name,
                           Progress cancellable)
    : OutputStream(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666),
                   std::move(name), std::move(cancellable)) {}

OutputStream OutputStream::standard_output(Progress cancellable) {
    return {::dup(STDOUT_FILENO), "standard output", std::move(cancellable)};
}

OutputStream::OutputStream(OutputStream&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      name_(std::move(other.name_)),
      cancellable_(std::move(other.cancellable_)) {}

OutputStream::~OutputStream() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputStream::write(std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(descriptor_, text.data(), text.size());
        if (count < 0 && errno == EINTR) {
            cancellable_.throw_if_cancelled();
            continue;
        }
        if (count < 0) throw_unwritable(name_);
        text.remove_prefix(static_cast<std::size_t>(count));
    }
}

void OutputStream::finish() {
    if (::close(std::exchange(descriptor_, -1)) != 0) throw_unwritable(name_);
}

}  // namespace burnish
