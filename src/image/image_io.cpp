// The functions of image_io.hpp: what needs no codec, and calls of the codecs.
#include "burnish/image_io.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "image/codecs.hpp"
#include "image/guard/format.hpp"
#include "image/image_parts.hpp"
#include "image/image_rows.hpp"
#include "image/written_format.hpp"

namespace burnish {
namespace {

struct Extension {
    std::string_view text;
    ImageFormat format;
};

constexpr std::array kExtensions = {
    Extension{".png", ImageFormat::png},   Extension{".jpg", ImageFormat::jpeg},
    Extension{".jpeg", ImageFormat::jpeg}, Extension{".tif", ImageFormat::tiff},
    Extension{".tiff", ImageFormat::tiff}, Extension{".exr", ImageFormat::exr},
};

std::optional<ImageFormat> format_of_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const Extension& known : kExtensions) {
        if (extension == known.text) return known.format;
    }
    return std::nullopt;
}

}  // namespace

ImageFormat require_written_format(const std::filesystem::path& path) {
    if (const auto format = format_of_extension(path)) return *format;
    const std::string extension = path.extension().string();
    throw UsageError(path.string(), "", "a name ending in .png, .jpg, .tif or .exr",
                     extension.empty() ? "no ending" : shown(extension));
}

bool is_image_file(const std::filesystem::path& path) {
    try {
        return image_format_of(read_file_head(path, kImageHeadBytes)).has_value();
    } catch (const Error&) {
        return false;
    }
}

bool is_raw_camera_name(const std::filesystem::path& path) {
    return has_raw_ending(path.string());
}

bool holds_linear(const std::filesystem::path& path) {
    return format_of_extension(path) == ImageFormat::exr;
}

bool holds_alpha(const std::filesystem::path& path) {
    return format_of_extension(path) != ImageFormat::jpeg;
}

void require_image_extension(const std::filesystem::path& path) {
    require_written_format(path);
}

const ImageChannel* ImagePart::find(std::string_view channel) const {
    for (const ImageChannel& candidate : channels)
        if (candidate.name == channel) return &candidate;
    return nullptr;
}

Image read_image(const std::filesystem::path& path, const ReadOptions& options) {
    return codecs().read_image(path, options);
}

Texture read_texture(const std::filesystem::path& path, ColorSpace color_space,
                     std::vector<std::string>* warnings) {
    return codecs().read_texture(path, color_space, warnings);
}

Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space, std::vector<std::string>* warnings) {
    return codecs().decode_texture(bytes, name, color_space, warnings);
}

ImageInfo read_image_info(const std::filesystem::path& path) {
    return codecs().read_image_info(path);
}

void write_image(const std::filesystem::path& path, const Image& image,
                 const std::map<std::string, std::string>& metadata, const WriteOptions& options) {
    codecs().write_image(path, image, metadata, options);
}

std::vector<ImagePart> read_image_parts(const std::filesystem::path& path) {
    return codecs().read_image_parts(path);
}

void write_image_parts(const std::filesystem::path& path, const std::vector<ImagePart>& parts) {
    codecs().write_image_parts(path, parts);
}

bool has_image_part_attribute(const std::filesystem::path& path, std::string_view name) {
    return codecs().has_image_part_attribute(path, name);
}

void write_data_picture(const std::filesystem::path& path, const DataPicture& picture,
                        const std::string& name, const std::function<void(double)>& step) {
    codecs().write_data_picture(path, picture, name, step);
}

}  // namespace burnish
