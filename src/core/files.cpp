#include "core/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <deque>
#include <optional>
#include <random>
#include <utility>

#include "burnish/error.hpp"

namespace burnish {

std::string reason_of(int error_number) {
    switch (error_number) {
        case ENOENT:
            return "no such file or folder";
        case EACCES:
        case EPERM:
            return "no permission";
        case EISDIR:
            return "a folder";
        case ENOSPC:
            return "no space left on the device";
        case EDQUOT:
            return "the disk quota is used up";
        case EFBIG:
            return "the file size limit is reached";
        case EROFS:
            return "a read-only file system";
        default:
            return std::generic_category().message(error_number);
    }
}

namespace {

namespace fs = std::filesystem;

[[noreturn]] void throw_unreadable(const fs::path& path, std::string_view found) {
    throw Error(path.string(), "", "a readable file", found);
}

[[noreturn]] void throw_unwritable(const fs::path& path, std::string_view found) {
    throw Error(path.string(), "", "a file that can be written", found);
}

class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    int get() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

    // Some file systems report a full disk only here.
    int close_checked() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

  private:
    int number_;
};

// ---- reading ------------------------------------------------------------------------------------

// At most `size` bytes; fewer at the end of the file only.
std::size_t read_up_to(const Descriptor& file, std::byte* to, std::size_t size,
                       const fs::path& path) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count = ::read(file.get(), to + done, size - done);
        if (count == 0) break;
        if (count < 0) {
            if (errno == EINTR) continue;
            throw_unreadable(path, reason_of(errno));
        }
        done += static_cast<std::size_t>(count);
    }
    return done;
}

// Opened without waiting: a named pipe that nobody writes to reads as empty instead of hanging.
Descriptor open_for_reading(const fs::path& path, struct stat& status) {
    Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
    if (!file || ::fstat(file.get(), &status) != 0) throw_unreadable(path, reason_of(errno));
    if (S_ISDIR(status.st_mode)) throw_unreadable(path, "a folder");
    if (!S_ISREG(status.st_mode) && !S_ISFIFO(status.st_mode)) throw_unreadable(path, "a device");
    if (S_ISFIFO(status.st_mode)) {
        const int flags = ::fcntl(file.get(), F_GETFL);
        ::fcntl(file.get(), F_SETFL, flags & ~O_NONBLOCK);
    }
    return file;
}

// ---- writing ------------------------------------------------------------------------------------

// 0 or the number of the error.
int write_all(const Descriptor& file, const std::byte* from, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t count = ::write(file.get(), from + done, size - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        if (count == 0) return ENOSPC;
        done += static_cast<std::size_t>(count);
    }
    return 0;
}

int flush_to_disk(const Descriptor& file) {
    if (::fsync(file.get()) == 0) return 0;
    // Not every file system can flush; no data are lost by that.
    return errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// A new, empty file with a name that no other file has. It is removed at the end unless it was
// kept.
class Temporary {
  public:
    // Messages name `path`.
    Temporary(const fs::path& folder, const fs::path& extension, const fs::path& path) {
        constexpr int kAttempts = 100;
        std::random_device random;
        for (int attempt = 0; attempt < kAttempts; ++attempt) {
            name_ = folder /
                    fmt::format(".burnish-{:08x}{:08x}{}", random(), random(), extension.string());
            const Descriptor file(
                ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                       S_IRUSR | S_IWUSR | S_IRGRP | S_IWGRP | S_IROTH | S_IWOTH));
            if (file) return;
            if (errno == EEXIST) continue;
            if (errno == ENOENT || errno == ENOTDIR) {
                throw_unwritable(path, "no folder " + shown(folder.string()));
            }
            throw_unwritable(path, reason_of(errno));
        }
        throw_unwritable(path, "no free temporary name");
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    ~Temporary() {
        if (!name_.empty()) ::unlink(name_.c_str());
    }

    const fs::path& name() const { return name_; }
    void keep() { name_.clear(); }

  private:
    fs::path name_;
};

std::optional<mode_t> mode_of(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return std::nullopt;
    return status.st_mode;
}

// Devices, pipes and the process's own descriptors take bytes, but cannot be replaced by a rename.
bool takes_a_stream(const fs::path& path) {
    const std::string text = path.lexically_normal().string();
    if (text == "/dev/stdout" || text == "/dev/stderr" || text.starts_with("/dev/fd/") ||
        text.starts_with("/proc/")) {
        return true;
    }
    const std::optional<mode_t> mode = mode_of(path);
    return mode && !S_ISREG(*mode) && !S_ISDIR(*mode);
}

// The file that a rename must replace: the file behind a symbolic link, not the link.
fs::path replaced_file(const fs::path& path) {
    std::error_code error;
    if (!fs::is_symlink(path, error)) return path;
    fs::path target = fs::weakly_canonical(path, error);
    return error || target.empty() ? path : target;
}

void require_replaceable(const fs::path& path) {
    if (path.empty()) throw_unwritable("(empty name)", "no name");
    const std::optional<mode_t> mode = mode_of(path);
    if (mode && S_ISDIR(*mode)) throw_unwritable(path, "a folder");
    // A rename would ignore the write protection.
    if (mode && ::access(path.c_str(), W_OK) != 0) throw_unwritable(path, reason_of(errno));
}

void stream_bytes(const fs::path& path, std::span<const std::byte> bytes) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (!file) throw_unwritable(path, reason_of(errno));
    int error = write_all(file, bytes.data(), bytes.size());
    if (error == 0) error = file.close_checked();
    if (error != 0) throw_unwritable(path, reason_of(error));
}

// Gives the finished temporary file the name and the permissions of the file that it replaces.
void commit(Temporary& temporary, const fs::path& target, const fs::path& path) {
    {
        Descriptor file(::open(temporary.name().c_str(), O_RDONLY | O_CLOEXEC));
        if (!file) throw_unwritable(path, "the temporary file gone");
        const std::optional<mode_t> old_mode = mode_of(target);
        if (old_mode) ::fchmod(file.get(), *old_mode & 07777U);
        int error = flush_to_disk(file);
        if (error == 0) error = file.close_checked();
        if (error != 0) throw_unwritable(path, reason_of(error));
    }
    if (::rename(temporary.name().c_str(), target.c_str()) != 0) {
        throw_unwritable(path, reason_of(errno));
    }
    temporary.keep();
    // The new name then survives a power cut; the contents do already.
    const Descriptor folder(::open(folder_of(target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder) flush_to_disk(folder);
}

fs::path folder_for_streams() {
    std::error_code error;
    const fs::path folder = fs::temp_directory_path(error);
    return error ? fs::path("/tmp") : folder;
}

// A file that is written under a temporary name and then renamed.
class Pending {
  public:
    explicit Pending(const fs::path& path)
        : path_(path),
          target_(checked_target(path)),
          temporary_(folder(), path.extension(), path) {}

    // Errors name the file that the caller asked for, not the temporary one.
    void write(const std::function<void(const fs::path&)>& writer) {
        try {
            writer(temporary_.name());
        } catch (const UsageError&) {
            throw;
        } catch (const Error& error) {
            std::string line = error.what();
            const std::string name = temporary_.name().string();
            const std::size_t at = line.find(name);
            if (at == line.npos) throw;
            throw Error(line.replace(at, name.size(), path_.string()));
        }
    }

    void finish() {
        if (target_.empty()) {
            stream_bytes(path_, read_file(temporary_.name()));
        } else {
            commit(temporary_, target_, path_);
        }
    }

  private:
    static fs::path checked_target(const fs::path& path) {
        if (takes_a_stream(path)) return {};
        require_replaceable(path);
        return replaced_file(path);
    }
    fs::path folder() const { return target_.empty() ? folder_for_streams() : folder_of(target_); }

    fs::path path_, target_;  // target_ is empty for a device or a pipe
    Temporary temporary_;
};

}  // namespace

std::vector<std::byte> read_file(const fs::path& path, std::uintmax_t limit_bytes) {
    struct stat status {};
    const Descriptor file = open_for_reading(path, status);
    const auto too_large = [&] {
        throw Error(path.string(), "", fmt::format("a file of at most {} bytes", limit_bytes),
                    "a larger one");
    };
    const auto size = static_cast<std::uintmax_t>(std::max<off_t>(status.st_size, 0));
    if (size > limit_bytes) too_large();
    std::vector<std::byte> bytes(static_cast<std::size_t>(size));
    bytes.resize(read_up_to(file, bytes.data(), bytes.size(), path));

    // Pipes and files of /proc have no size, and a file may grow while it is read.
    std::vector<std::byte> more(std::size_t{1} << 16);
    while (const std::size_t count = read_up_to(file, more.data(), more.size(), path)) {
        if (bytes.size() + count > limit_bytes) too_large();
        bytes.insert(bytes.end(), more.begin(),
                     more.begin() + static_cast<std::vector<std::byte>::difference_type>(count));
    }
    return bytes;
}

std::vector<std::byte> read_file_head(const fs::path& path, std::size_t count) {
    struct stat status {};
    const Descriptor file = open_for_reading(path, status);
    std::vector<std::byte> bytes(count);
    bytes.resize(read_up_to(file, bytes.data(), bytes.size(), path));
    return bytes;
}

std::string read_text_file(const fs::path& path, std::uintmax_t limit_bytes) {
    const std::vector<std::byte> bytes = read_file(path, limit_bytes);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_file_whole(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    Pending file(path);
    file.write(write);
    file.finish();
}

void write_files_whole(std::span<const FileToWrite> files) {
    std::deque<Pending> pending;
    for (const FileToWrite& file : files) pending.emplace_back(file.path).write(file.write);
    while (!pending.empty()) {
        pending.back().finish();
        pending.pop_back();
    }
}

void write_bytes(const fs::path& path, std::span<const std::byte> bytes) {
    if (takes_a_stream(path)) {
        stream_bytes(path, bytes);
        return;
    }
    write_file_whole(path, [&](const fs::path& temporary) {
        Descriptor file(::open(temporary.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
        if (!file) throw_unwritable(path, reason_of(errno));
        int error = write_all(file, bytes.data(), bytes.size());
        if (error == 0) error = file.close_checked();
        if (error != 0) throw_unwritable(path, reason_of(error));
    });
}

void write_text_file(const fs::path& path, std::string_view text) {
    write_bytes(path, std::as_bytes(std::span(text.data(), text.size())));
}

void require_writable(const fs::path& path) {
    if (takes_a_stream(path)) return;
    require_replaceable(path);
    const Temporary probe(folder_of(replaced_file(path)), path.extension(), path);
}

}  // namespace burnish
