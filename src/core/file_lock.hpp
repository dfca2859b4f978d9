// One writer of a file at a time, among the processes of a machine.
#pragma once

#include <filesystem>

namespace burnish {

// Holds PATH.lock, which is removed in the end. A process that ends in whatever way no longer holds it.
class FileLock {
  public:
    // Throws Error when another process holds the lock, or when there can be none in the folder.
    explicit FileLock(const std::filesystem::path& path);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

  private:
    std::filesystem::path path_;
    int descriptor_ = -1;
};

}  // namespace burnish
