// The codecs of picture files. OpenImageIO brings more than two hundred shared libraries, whose
// relocation takes a quarter of a second of processor time. They are loaded when the first picture is
// read or written: the codecs are a module of their own, burnish_codecs.so.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/image_io.hpp"
#include "image/image_parts.hpp"
#include "image/image_rows.hpp"

namespace burnish {

// The functions of image_io.hpp, image_parts.hpp and image_rows.hpp. Thread-safe.
class Codecs {
  public:
    virtual ~Codecs() = default;
    virtual Image read_image(const std::filesystem::path& path,
                             const ReadOptions& options) const = 0;
    virtual Texture read_texture(const std::filesystem::path& path, ColorSpace color_space,
                                 std::vector<std::string>* warnings) const = 0;
    virtual Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                                   ColorSpace color_space,
                                   std::vector<std::string>* warnings) const = 0;
    virtual ImageInfo read_image_info(const std::filesystem::path& path) const = 0;
    virtual void write_image(const std::filesystem::path& path, const Image& image,
                             const std::map<std::string, std::string>& metadata,
                             const WriteOptions& options) const = 0;
    virtual std::vector<ImagePart> read_image_parts(const std::filesystem::path& path) const = 0;
    virtual void write_image_parts(const std::filesystem::path& path,
                                   const std::vector<ImagePart>& parts) const = 0;
    virtual bool has_image_part_attribute(const std::filesystem::path& path,
                                          std::string_view name) const = 0;
    virtual void write_data_picture(const std::filesystem::path& path, const DataPicture& picture,
                                    const std::string& name,
                                    const std::function<void(double)>& step) const = 0;
};

// Loads the module at the first call, from the folder of the program or the library, or from the
// folder of libraries beside it. Throws Error when it is not there or is of another version.
const Codecs& codecs();

}  // namespace burnish
