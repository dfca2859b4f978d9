#include "formats/gltf/gltf_images.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <exception>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/progress.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "formats/gltf/gltf_extensions.hpp"

namespace burnish {
namespace {

// Limit of decoded texels. Pictures compress a thousandfold, so a small file can require any
// amount. 16 GiB are sixty RGBA textures of 8192 x 8192, more than a renderer can upload.
constexpr std::uint64_t kMostTexelBytes = std::uint64_t{16} << 30;

template <class Stored>
void fill_blue_with(Texture& texture, Stored one) {
    const auto channels = static_cast<std::size_t>(texture.channels);
    for (std::size_t i = 2; (i + 1) * sizeof one <= texture.texels.size(); i += channels)
        std::memcpy(texture.texels.data() + i * sizeof one, &one, sizeof one);
}

void fill_blue(Texture& texture) {
    if (texture.channels < 3) return;
    if (texture.type == TexelType::u8) fill_blue_with(texture, std::uint8_t{0xFF});
    if (texture.type == TexelType::u16) fill_blue_with(texture, std::uint16_t{0xFFFF});
    if (texture.type == TexelType::f32) fill_blue_with(texture, 1.0f);
}

}  // namespace

int GltfImages::use(int index, GltfReading reading, std::string_view user) {
    const GltfTexture& texture =
        item_at(document_.textures, index, report_, fmt::format("{}.index", user));
    std::vector<int> images;
    for (const GltfTexture::Version& version : texture.versions) {
        item_at(document_.images, version.image, report_, version.key);
        images.push_back(version.image);
    }
    if (!texture.unread.empty()) {
        const std::string_view remedy = gltf_extension_remedy(texture.unread);
        report_.warn(fmt::format(
            "textures[{}]: {} is not read: {}; {}", index, texture.unread,
            images.empty() ? fmt::format("{} is not used", user) : "its other version is used",
            remedy));
    } else if (images.empty()) {
        report_.warn(fmt::format("textures[{}]: no picture: {} is not used", index, user));
    }
    if (images.empty()) return -1;
    const auto [slot, fresh] =
        slots_.try_emplace({images, reading}, static_cast<int>(used_.size()));
    if (fresh) used_.push_back({texture.versions, reading});
    return slot->second;
}

Texture GltfImages::decode_one(int index, GltfReading reading,
                               std::span<const std::byte> view) const {
    const GltfImage& image = document_.images[static_cast<std::size_t>(index)];
    const std::string key = fmt::format("images[{}]", index);
    const ColorSpace space = reading == GltfReading::color ? ColorSpace::srgb : ColorSpace::linear;
    if (image.uri.empty() && image.buffer_view < 0)
        report_.fail(key, "either uri or bufferView", "neither");
    if (image.uri.empty())
        return decode_texture(view, fmt::format("{}: {}", report_.file(), key), space);
    const std::string uri_key = key + ".uri";
    if (const auto bytes = decode_data_uri(image.uri, uri_key, report_))
        return decode_texture(*bytes, fmt::format("{}: {}", report_.file(), uri_key), space);
    const std::filesystem::path& path = paths_.at(index);
    return decode_texture(read_file(path), path.string(), space);
}

GltfImages::Tried GltfImages::try_versions(const Wanted& wanted) const {
    Tried tried;
    for (const GltfTexture::Version& version : wanted.versions) {
        try {
            if (const auto it = broken_.find(version.image); it != broken_.end())
                throw Error(it->second);
            const auto view = views_.find(version.image);
            tried.texture =
                decode_one(version.image, wanted.reading,
                           view == views_.end() ? std::span<const std::byte>() : view->second);
            if (wanted.reading == GltfReading::direction) fill_blue(tried.texture);
            tried.read = true;
            return tried;
        } catch (const Interrupted&) {
            throw;
        } catch (const Error& error) {
            tried.failures.emplace_back(error.what());
        }
    }
    return tried;
}

void GltfImages::locate(int index) {
    const GltfImage& image = document_.images[static_cast<std::size_t>(index)];
    try {
        if (image.buffer_view >= 0)
            views_[index] =
                buffers_.view(image.buffer_view, fmt::format("images[{}].bufferView", index));
        else if (!image.uri.empty() && !image.uri.starts_with("data:"))
            paths_[index] =
                resolve_gltf_uri(files_, container_.folder, GltfFile::picture, image.uri,
                                 fmt::format("images[{}].uri", index), report_);
    } catch (const Error& error) {
        broken_[index] = error.what();
    }
}

GltfPictures GltfImages::decode() {
    for (const Wanted& wanted : used_)
        for (const GltfTexture::Version& version : wanted.versions) locate(version.image);
    std::vector<Tried> tried(used_.size());
    std::atomic<std::uint64_t> total = 0;
    std::vector<std::exception_ptr> errors(used_.size());
    parallel_for(used_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            try {
                tried[i] = try_versions(used_[i]);
                if ((total += tried[i].texture.texels.size()) > kMostTexelBytes)
                    report_.fail("images", "at most 16 GiB of texels", "more");
            } catch (...) {
                errors[i] = std::current_exception();
            }
        }
    });
    // Rethrow the first error in the file's order, independent of thread timing.
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    GltfPictures pictures;
    for (Tried& one : tried) {
        pictures.textures.push_back(std::move(one.texture));
        pictures.failures.push_back(one.read || one.failures.empty() ? "" : one.failures.front());
        if (!one.read) continue;
        for (const std::string& failure : one.failures)
            report_.warn(failure + ": the texture's other version is used");
    }
    return pictures;
}

}  // namespace burnish
