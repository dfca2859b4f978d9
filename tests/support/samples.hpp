// Small image files in every supported format, made in memory, and a temporary folder.
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

// A folder in the system's temporary folder, removed by the destructor.
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

// A smooth picture with some noise: encoders can neither reduce it to nothing nor store it raw.
Image sample_picture(int width, int height, int channels);

// Options for encoding a picture with OpenImageIO; `pixel_type` as in OpenImageIO; `attributes`
// such as "compression=piz" or "tile=16".
struct Encoding {
    std::string label;
    std::string format;
    std::string pixel_type;
    int channels;
    std::vector<std::string> attributes;
    friend void PrintTo(const Encoding& encoding, std::ostream* out) { *out << encoding.label; }
};
const std::vector<Encoding>& encodings();  // one for each common kind of file
Bytes encode(const Encoding& encoding, const Image& picture);

// A PNG assembled from parts. `rows` are the filtered rows, stored uncompressed.
struct PngChunk {
    std::string type;
    std::string data;
};
Bytes png_of(std::uint32_t width, std::uint32_t height, int depth, int color_type,
             const std::vector<PngChunk>& between, const std::string& rows);

// what() of the burnish::Error that `work` throws; fails the test if none is thrown.
std::string error_of(const std::function<void()>& work);

}  // namespace burnish::test
