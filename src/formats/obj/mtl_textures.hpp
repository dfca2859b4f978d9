// The pictures that material libraries name: found, read, and put together into textures.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/image.hpp"

namespace burnish {

// A picture, and the channel that a single value is read from; -1: all of them.
struct MtlPicture {
    std::filesystem::path path;  // empty: none
    int channel = -1;
    auto operator<=>(const MtlPicture&) const = default;
};

class MtlTextures {
  public:
    // Numbers of textures, which decode() reads. Equal requests have one number.
    int plain(const std::filesystem::path& path, ColorSpace color_space);
    // Roughness into G, metallic into B; 1 where there is no picture.
    int metallic_roughness(const MtlPicture& roughness, const MtlPicture& metallic);
    // The color picture (white without one) with the alpha of the other one.
    int color_with_alpha(const std::filesystem::path& color, const std::filesystem::path& alpha);

    // Reads all of them. A picture that cannot be read becomes an empty texture and a warning.
    std::vector<Texture> decode();

    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    enum class Kind { plain, metallic_roughness, color_with_alpha };
    struct Request {
        Kind kind;
        ColorSpace color_space;
        MtlPicture first, second;
        auto operator<=>(const Request&) const = default;
    };
    int number_of(const Request& request);
    void warn(std::string line) { warnings_.push_back(std::move(line)); }
    static Texture make(const Request& request, std::vector<std::string>& failures);

    std::map<Request, int> numbers_;
    std::vector<Request> requests_;
    std::vector<std::string> warnings_;
};

// True when most texels are nearly opaque or nearly clear: cut out, not mixed.
bool is_cut_out(const Texture& texture);

}  // namespace burnish
