// An image file open in memory: checked, then read through OpenImageIO. Private to the image
// reader.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/codecs/exr_window.hpp"
#include "image/codecs/memory_proxy.hpp"
#include "image/guard/format.hpp"

namespace burnish {

// A file whose container has been walked. `bytes` and `name` outlive it.
struct CheckedFile {
    CheckedFile(std::span<const std::byte> bytes_, const std::string& name_)
        : bytes(bytes_),
          name(name_),
          format(require_format_of_file(bytes, name)),
          structure(check_image_structure(format, bytes, name)) {}

    std::span<const std::byte> bytes;
    const std::string& name;
    ImageFormat format;
    ImageStructure structure;
};

// Bytes as a file that has a path, for the decoders that take nothing else.
class FileInMemory {
  public:
    FileInMemory(std::span<const std::byte> bytes, const std::string& name);
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;
    ~FileInMemory();
    const std::string& path() const { return path_; }

  private:
    int number_;
    std::string path_;
};

class ImageFile {
  public:
    explicit ImageFile(const CheckedFile& file);

    [[noreturn]] void fail(std::string_view reason) const;

    ImageFormat format() const { return format_; }
    const OIIO::ImageSpec& spec() const { return spec_; }
    const std::string& name() const { return name_; }

    // OpenEXR: the names of all parts with R, G and B; the first of them is read.
    const std::vector<std::string>& color_parts() const { return color_parts_; }

    // What the file holds, and what its picture is.
    PixelWindow data_window() const;
    PixelWindow display_window() const;

    // Whether the file says of its integers that they are linear. Those of sensors are.
    bool is_linear() const;

    // Channels [first, first + count) of the data window as texels of `type`.
    std::vector<std::byte> read_pixels(int first, int count, const OIIO::TypeDesc& type);

  private:
    void open();
    void choose_part();
    void check_spec(std::uint64_t file_bytes) const;
    bool read_rows(int begin, int end, int first, int count, const OIIO::TypeDesc& type,
                   std::byte* to);

    const std::string& name_;
    ImageFormat format_;
    std::vector<std::byte> filtered_;  // empty when the file is read as it is
    MemoryReader source_;
    std::unique_ptr<FileInMemory> on_disk_;  // only for decoders that need a path
    OIIO::ImageSpec spec_;
    int part_ = 0;
    std::vector<std::string> color_parts_;
    std::unique_ptr<OIIO::ImageInput> input_;  // last: closed before its source goes
};

}  // namespace burnish
