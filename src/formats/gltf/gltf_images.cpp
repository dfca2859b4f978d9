#include "formats/gltf/gltf_images.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cstdint>
#include <exception>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"

namespace burnish {
namespace {

// Limit of decoded texels. Pictures compress a thousandfold, so a small file can require any
// amount. 16 GiB are sixty RGBA textures of 8192 x 8192, more than a renderer can upload.
constexpr std::uint64_t kMostTexelBytes = std::uint64_t{16} << 30;

}  // namespace

int GltfImages::use(int image, ColorSpace color_space, std::string_view user) {
    item_at(document_.images, image, report_, user);
    const auto [slot, fresh] =
        slots_.try_emplace({image, color_space}, static_cast<int>(used_.size()));
    if (fresh) used_.emplace_back(image, color_space);
    return slot->second;
}

Texture GltfImages::decode_one(int index, ColorSpace color_space,
                               std::span<const std::byte> view) const {
    const GltfImage& image = document_.images[static_cast<std::size_t>(index)];
    const std::string key = fmt::format("images[{}]", index);
    if (image.uri.empty())
        return decode_texture(view, fmt::format("{}: {}", report_.file(), key), color_space);
    const std::string uri_key = key + ".uri";
    if (const auto bytes = decode_data_uri(image.uri, uri_key, report_))
        return decode_texture(*bytes, fmt::format("{}: {}", report_.file(), uri_key), color_space);
    const auto path = resolve_gltf_uri(container_.folder, image.uri, uri_key, report_);
    try {
        return decode_texture(read_file(path), path.string(), color_space);
    } catch (const Error& error) {
        throw Error(fmt::format("{}: {}: {}", report_.file(), uri_key, error.what()));
    }
}

std::vector<Texture> GltfImages::decode() {
    // Decompresses views on one thread, because decompression is not thread-safe.
    std::vector<std::span<const std::byte>> views(used_.size());
    for (std::size_t i = 0; i < used_.size(); ++i) {
        const int image = used_[i].first;
        const int view = document_.images[static_cast<std::size_t>(image)].buffer_view;
        if (view >= 0) views[i] = buffers_.view(view, fmt::format("images[{}].bufferView", image));
    }
    std::vector<Texture> textures(used_.size());
    std::atomic<std::uint64_t> total = 0;
    std::vector<std::exception_ptr> errors(used_.size());
    parallel_for(used_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            try {
                textures[i] = decode_one(used_[i].first, used_[i].second, views[i]);
                if ((total += textures[i].texels.size()) > kMostTexelBytes)
                    report_.fail("images", "at most 16 GiB of texels", "more");
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    });
    // Rethrow the first error in the file's order, independent of thread timing.
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    return textures;
}

}  // namespace burnish
