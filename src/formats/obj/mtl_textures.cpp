#include "formats/obj/mtl_textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstdint>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "core/parallel.hpp"
#include "image/texel_value.hpp"

namespace burnish {
namespace {

namespace fs = std::filesystem;

// As for glTF: sixty RGBA textures of 8192 x 8192, more than a renderer can upload.
constexpr std::uint64_t kMostTexelBytes = std::uint64_t{16} << 30;

std::size_t cell(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
}

std::size_t bytes_of(TexelType type) {
    return type == TexelType::u8 ? 1 : type == TexelType::u16 ? 2 : 4;
}

Texture blank(int width, int height, int channels, TexelType type, ColorSpace color_space) {
    Texture texture{{}, width, height, channels, type, color_space, {}};
    texture.texels.resize(cell(0, height, width) * static_cast<std::size_t>(channels) *
                          bytes_of(type));
    return texture;
}

// The value of a channel at a place of a picture of another size: the nearest texel's.
float nearest(const Texture& from, int channel, int x, int y, const Texture& to) {
    const int fx = static_cast<int>((std::int64_t{2} * x + 1) * from.width / (2 * to.width));
    const int fy = static_cast<int>((std::int64_t{2} * y + 1) * from.height / (2 * to.height));
    const auto at = cell(fx, fy, from.width) * static_cast<std::size_t>(from.channels);
    return texel_value(from, at + static_cast<std::size_t>(std::min(channel, from.channels - 1)));
}

// Of the size of the picture with more texels: two narrow ones, across each other, would make a huge
// one.
const Texture& larger(const Texture& a, const Texture& b) {
    return cell(0, a.height, a.width) >= cell(0, b.height, b.width) ? a : b;
}

TexelType finer(TexelType a, TexelType b) {
    return bytes_of(a) >= bytes_of(b) ? a : b;
}

// Either picture may be empty, not both.
Texture joined_metallic_roughness(const Texture& roughness, int roughness_channel,
                                  const Texture& metallic, int metallic_channel) {
    const Texture& size = larger(roughness, metallic);
    Texture to =
        blank(size.width, size.height, 3, finer(roughness.type, metallic.type), ColorSpace::linear);
    to.name = roughness.empty() ? metallic.name : roughness.name;
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            const std::size_t at = 3 * cell(x, y, to.width);
            set_texel_value(to, at, 1.0f);
            set_texel_value(
                to, at + 1,
                roughness.empty() ? 1.0f : nearest(roughness, roughness_channel, x, y, to));
            set_texel_value(
                to, at + 2,
                metallic.empty() ? 1.0f : nearest(metallic, metallic_channel, x, y, to));
        }
    return to;
}

// Alpha is the alpha channel of its picture, else its first channel.
Texture joined_color_alpha(const Texture& color, const Texture& alpha) {
    const bool has_color = !color.empty();
    const Texture& size = larger(color, alpha);
    Texture to = blank(size.width, size.height, 4, has_color ? color.type : TexelType::u8,
                       has_color ? color.color_space : ColorSpace::srgb);
    to.name = has_color ? color.name : alpha.name;
    const bool has_alpha = alpha.channels == 2 || alpha.channels == 4;
    const bool gray = color.channels < 3;
    for (int y = 0; y < to.height; ++y)
        for (int x = 0; x < to.width; ++x) {
            const std::size_t at = 4 * cell(x, y, to.width);
            for (int c = 0; c < 3; ++c)
                set_texel_value(to, at + static_cast<std::size_t>(c),
                                has_color ? nearest(color, gray ? 0 : c, x, y, to) : 1.0f);
            set_texel_value(to, at + 3,
                            nearest(alpha, has_alpha ? alpha.channels - 1 : 0, x, y, to));
        }
    return to;
}

}  // namespace

int MtlTextures::number_of(const Request& request) {
    const auto [at, fresh] = numbers_.try_emplace(request, static_cast<int>(requests_.size()));
    if (fresh) requests_.push_back(request);
    return at->second;
}

int MtlTextures::plain(const fs::path& path, ColorSpace color_space) {
    return number_of({Kind::plain, color_space, {path, -1}, {}});
}

int MtlTextures::metallic_roughness(const MtlPicture& roughness, const MtlPicture& metallic) {
    return number_of({Kind::metallic_roughness, ColorSpace::linear, roughness, metallic});
}

int MtlTextures::color_with_alpha(const fs::path& color, const fs::path& alpha) {
    return number_of({Kind::color_with_alpha, ColorSpace::srgb, {color, -1}, {alpha, -1}});
}

Texture MtlTextures::make(const Request& request, std::vector<std::string>& failures) {
    const auto read = [&](const MtlPicture& picture, ColorSpace color_space) {
        if (picture.path.empty()) return Texture();
        try {
            return read_texture(picture.path, color_space);
        } catch (const Error& error) {
            failures.emplace_back(error.what());
            return Texture();
        }
    };
    Texture first = read(request.first, request.color_space);
    if (request.kind == Kind::plain) return first;
    Texture second =
        request.second == request.first ? first : read(request.second, ColorSpace::linear);
    if (request.kind == Kind::metallic_roughness) {
        if (first.empty() && second.empty()) return {};
        return joined_metallic_roughness(first, std::max(request.first.channel, 0), second,
                                         std::max(request.second.channel, 0));
    }
    // Without the alpha picture, and for one picture of both, which has its own alpha or none.
    if (second.empty() || request.second == request.first) return first;
    return joined_color_alpha(first, second);
}

std::vector<Texture> MtlTextures::decode() {
    std::vector<Texture> textures(requests_.size());
    std::vector<std::vector<std::string>> failures(requests_.size());
    std::atomic<std::uint64_t> total = 0;
    parallel_for(requests_.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            // Checked before, too: what is read in vain takes time.
            if (total < kMostTexelBytes) textures[i] = make(requests_[i], failures[i]);
            if ((total += textures[i].texels.size()) < kMostTexelBytes) continue;
            textures[i] = Texture();
            failures[i].push_back("more than 16 GiB of texels");
        }
    });
    for (const std::vector<std::string>& lines : failures)
        for (const std::string& line : lines) warn(line + ": the texture is not used");
    return textures;
}

bool is_cut_out(const Texture& texture) {
    std::size_t sure = 0, count = 0;
    const auto channels = static_cast<std::size_t>(texture.channels);
    for (std::size_t i = channels - 1; i < cell(0, texture.height, texture.width) * channels;
         i += channels, ++count) {
        const float alpha = texel_value(texture, i);
        sure += alpha < 0.1f || alpha > 0.9f;
    }
    // Cut-out pictures have smooth edges: a quarter of the texels is more than leaves have of them.
    return 4 * sure >= 3 * count;
}

}  // namespace burnish
