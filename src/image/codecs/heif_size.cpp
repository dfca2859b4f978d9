#include "image/codecs/heif_size.hpp"

#include <fmt/format.h>
#include <libheif/heif.h>

#include <memory>

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

std::string heif_size_fault(std::span<const std::byte> bytes, int width, int height) {
    const ContextOwner context(heif_context_alloc());
    heif_error error = heif_context_read_from_memory_without_copy(context.get(), bytes.data(),
                                                                  bytes.size(), nullptr);
    if (error.code != heif_error_Ok) return error.message;
    heif_image_handle* handle = nullptr;
    error = heif_context_get_primary_image_handle(context.get(), &handle);
    const HandleOwner handle_owner(handle);
    if (error.code != heif_error_Ok) return error.message;
    heif_image* image = nullptr;
    error = heif_decode_image(handle, &image, heif_colorspace_RGB, heif_chroma_interleaved_RGB,
                              nullptr);
    const ImageOwner image_owner(image);
    if (error.code != heif_error_Ok) return error.message;
    const int decoded_width = heif_image_get_width(image, heif_channel_interleaved);
    const int decoded_height = heif_image_get_height(image, heif_channel_interleaved);
    if (decoded_width == width && decoded_height == height) return "";
    return fmt::format("a frame of {} x {} pixels under a header of {} x {}", decoded_width,
                       decoded_height, width, height);
}

}  // namespace burnish
