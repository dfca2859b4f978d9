// Files written whole or not at all, and read with limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// The text of an errno in every message about files: "no such file or folder".
std::string reason_of(int error_number);

// Reads the whole file (or pipe). Throws Error "<path>: expected a readable file, found <reason>";
// missing files, directories, devices and files over `limit_bytes` included.
std::vector<std::byte> read_file(const std::filesystem::path& path,
                                 std::uintmax_t limit_bytes = std::uintmax_t{4} << 30);
std::string read_text_file(const std::filesystem::path& path,
                           std::uintmax_t limit_bytes = std::uintmax_t{1} << 30);

// Reads the first `count` bytes, fewer when the file is shorter: they tell the format before the
// whole file is read. Throws like read_file.
std::vector<std::byte> read_file_head(const std::filesystem::path& path, std::size_t count);

// Calls `write(temporary path in the same folder, same extension)`, flushes it to disk and renames
// it over `path` (over the file a symbolic link points to), keeping the old file's permissions.
// When `write` or the flush throws, or the disk is full, the temporary is removed and the old file
// is left as it was; an Error that names the temporary is thrown on with `path` in its place.
// `write` itself must notice its short writes. Devices and pipes (/dev/full,
// /dev/stdout) receive a copy of the temporary, every write checked.
void write_file_whole(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path&)>& write);

// The same for contents in memory, with every write checked. Prefer these.
void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_text_file(const std::filesystem::path& path, std::string_view text);

// Writes several files, or none of them. All are written under temporary names, then renamed, the
// last of the list first. A failure before the renames leaves every old file as it was. A rename
// fails only when the file system fails.
struct FileToWrite {
    std::filesystem::path path;
    std::function<void(const std::filesystem::path&)> write;  // as for write_file_whole
};
void write_files_whole(std::span<const FileToWrite> files);

// Throws Error when `path` cannot be written (missing or read-only folder, read-only file, a
// directory of that name). Jobs call it before hours of work. It leaves no file behind.
void require_writable(const std::filesystem::path& path);

}  // namespace burnish
