#include "image/codecs/heif_size.hpp"

#include <fmt/format.h>
#include <libheif/heif.h>

#include <memory>

#include "burnish/error.hpp"
#include "core/text.hpp"

namespace burnish {
namespace {

struct Release {
    void operator()(heif_context* context) const { heif_context_free(context); }
    void operator()(heif_image_handle* handle) const { heif_image_handle_release(handle); }
    void operator()(heif_image* image) const { heif_image_release(image); }
};
using ContextOwner = std::unique_ptr<heif_context, Release>;
using HandleOwner = std::unique_ptr<heif_image_handle, Release>;
using ImageOwner = std::unique_ptr<heif_image, Release>;

}  // namespace

void require_heif_size(std::span<const std::byte> bytes, int width, int height,
                       const std::string& name) {
    const auto require = [&](const heif_error& error) {
        if (error.code == heif_error_Ok) return;
        throw Error(name, "", "a readable HEIF or AVIF image",
                    one_line(error.message) + ": convert it to PNG, if other programs show it");
    };
    const ContextOwner context(heif_context_alloc());
    require(heif_context_read_from_memory_without_copy(context.get(), bytes.data(), bytes.size(),
                                                       nullptr));
    heif_image_handle* handle = nullptr;
    require(heif_context_get_primary_image_handle(context.get(), &handle));
    const HandleOwner handle_owner(handle);
    heif_image* image = nullptr;
    require(heif_decode_image(handle, &image, heif_colorspace_RGB, heif_chroma_interleaved_RGB,
                              nullptr));
    const ImageOwner image_owner(image);
    const int decoded_width = heif_image_get_width(image, heif_channel_interleaved);
    const int decoded_height = heif_image_get_height(image, heif_channel_interleaved);
    if (decoded_width == width && decoded_height == height) return;
    throw Error(name, "",
                fmt::format("a picture of {} x {} pixels, as its header states", width, height),
                fmt::format("{} x {}: convert it to PNG, if other programs show it", decoded_width,
                            decoded_height));
}

}  // namespace burnish
