// Bytes to a file or to the standard output, every write checked.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "burnish/progress.hpp"

namespace burnish {

class OutputStream {
  public:
    // Writes to the file at `path`; messages call it `name`. Throws Error, as do `write` and
    // `finish`, when it cannot be written; `write` throws Interrupted when a signal ends its wait
    // and `cancellable` is cancelled.
    OutputStream(const std::filesystem::path& path, std::string name, Progress cancellable = {});
    static OutputStream standard_output(Progress cancellable = {});

    OutputStream(OutputStream&& other) noexcept;
    OutputStream& operator=(OutputStream&&) = delete;
    ~OutputStream();

    void write(std::string_view text);
    void finish();  // some file systems report a full disk only when a file is closed

  private:
    OutputStream(int descriptor, std::string name, Progress cancellable);

    int descriptor_;
    std::string name_;
    Progress cancellable_;
};

}  // namespace burnish
