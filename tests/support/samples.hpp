// Small image files of every format we read, made in memory, and a folder that cleans up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "burnish/image.hpp"

namespace burnish::test {

using Bytes = std::vector<std::byte>;

// A folder of its own under the system's temporary folder, removed at the end.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }
    std::size_t entries() const;

  private:
    std::filesystem::path path_;
};

void save(const std::filesystem::path& path, std::span<const std::byte> bytes);
Bytes load(const std::filesystem::path& path);

// A smooth picture with some noise, so that encoders neither collapse nor store it.
Image sample_picture(int width, int height, int channels);

// The picture through an encoder of OpenImageIO; `pixel_type` as OpenImageIO names it; `attributes`
// such as "compression=piz" or "tile=16".
struct Encoding {
    std::string label;
    std::string format;
    std::string pixel_type;
    int channels;
    std::vector<std::string> attributes;
    friend void PrintTo(const Encoding& encoding, std::ostream* out) { *out << encoding.label; }
};
const std::vector<Encoding>& encodings();  // one of each kind that people have
Bytes encode(const Encoding& encoding, const Image& picture);

// A PNG put together by hand. `rows` are the filtered rows, stored uncompressed.
struct PngChunk {
    std::string type;
    std::string data;
};
Bytes png_of(std::uint32_t width, std::uint32_t height, int depth, int color_type,
             const std::vector<PngChunk>& between, const std::string& rows);

// what() of the burnish::Error that `work` throws; a test failure when it throws none.
std::string error_of(const std::function<void()>& work);

}  // namespace burnish::test
