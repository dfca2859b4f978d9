#include "core/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "burnish/error.hpp"
#include "core/files.hpp"

namespace burnish {

FileLock::FileLock(const std::filesystem::path& path) : path_(path.string() + ".lock") {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
        throw Error(path.string(), "",
                    "a folder in which " + path_.filename().string() + " can be made",
                    reason_of(errno));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int error = errno;
    ::close(descriptor_);
    throw Error(path.string(), "", "no other process that writes it",
                error == EWOULDBLOCK ? "one (" + path_.filename().string() + " is held)"
                                     : reason_of(error));
}

FileLock::~FileLock() {
    // Before the lock is given up: a later process makes a file of its own.
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    ::close(descriptor_);
}

}  // namespace burnish
