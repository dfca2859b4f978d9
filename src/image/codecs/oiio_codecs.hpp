// The codecs of codecs.hpp through OpenImageIO. Each function is in the source of its subject.
#pragma once

#include "image/codecs.hpp"

namespace burnish::oiio {

const Codecs& codecs();

Image read_image(const std::filesystem::path& path, const ReadOptions& options);
Texture read_texture(const std::filesystem::path& path, ColorSpace color_space,
                     std::vector<std::string>* warnings);
Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                       ColorSpace color_space, std::vector<std::string>* warnings);
ImageInfo read_image_info(const std::filesystem::path& path);
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::map<std::string, std::string>& metadata, const WriteOptions& options);
std::vector<ImagePart> read_image_parts(const std::filesystem::path& path);
void write_image_parts(const std::filesystem::path& path, const std::vector<ImagePart>& parts);
bool has_image_part_attribute(const std::filesystem::path& path, std::string_view name);
void write_data_picture(const std::filesystem::path& path, const DataPicture& picture,
                        const std::string& name, const std::function<void(double)>& step);

}  // namespace burnish::oiio
