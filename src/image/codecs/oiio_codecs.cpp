#include "image/codecs/oiio_codecs.hpp"

#include <string_view>

#include "burnish/version.hpp"

namespace burnish {
namespace {

class OiioCodecs final : public Codecs {
  public:
    Image read_image(const std::filesystem::path& path, const ReadOptions& options) const override {
        return oiio::read_image(path, options);
    }
    Texture read_texture(const std::filesystem::path& path, ColorSpace color_space,
                         std::vector<std::string>* warnings) const override {
        return oiio::read_texture(path, color_space, warnings);
    }
    Texture decode_texture(std::span<const std::byte> bytes, const std::string& name,
                           ColorSpace color_space,
                           std::vector<std::string>* warnings) const override {
        return oiio::decode_texture(bytes, name, color_space, warnings);
    }
    ImageInfo read_image_info(const std::filesystem::path& path) const override {
        return oiio::read_image_info(path);
    }
    void write_image(const std::filesystem::path& path, const Image& image,
                     const std::map<std::string, std::string>& metadata,
                     const WriteOptions& options) const override {
        oiio::write_image(path, image, metadata, options);
    }
    std::vector<ImagePart> read_image_parts(const std::filesystem::path& path) const override {
        return oiio::read_image_parts(path);
    }
    void write_image_parts(const std::filesystem::path& path,
                           const std::vector<ImagePart>& parts) const override {
        oiio::write_image_parts(path, parts);
    }
    bool has_image_part_attribute(const std::filesystem::path& path,
                                  std::string_view name) const override {
        return oiio::has_image_part_attribute(path, name);
    }
    void write_data_picture(const std::filesystem::path& path, const DataPicture& picture,
                            const std::string& name,
                            const std::function<void(double)>& step) const override {
        oiio::write_data_picture(path, picture, name, step);
    }
};

}  // namespace

const Codecs& oiio::codecs() {
    static const OiioCodecs one;
    return one;
}

}  // namespace burnish

// The entry of the module; null for another version, whose classes may differ.
extern "C" __attribute__((visibility("default"))) const burnish::Codecs* burnish_codecs(
    const char* version) {
    return burnish::version() == std::string_view(version) ? &burnish::oiio::codecs() : nullptr;
}
