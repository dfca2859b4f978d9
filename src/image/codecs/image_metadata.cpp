#include "image/codecs/image_metadata.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "burnish/error.hpp"

namespace burnish {
namespace {

constexpr const char* kDescription = "ImageDescription";

// Bytes of a description: JPEG stores it twice in one segment of at most 64 KiB.
constexpr std::size_t kMaxDescription = 30000;

// Bytes that are shown of the value of an attribute: profiles and thumbnails hold megabytes.
constexpr std::size_t kMaxShown = 30000;

// Only our names have a colon: a description in plain words may have an equals sign, but hardly a
// colon before it.
bool is_our_name(std::string_view name) {
    return name.find(':') != std::string_view::npos;
}

void take_apart(const std::string& description, Metadata& metadata) {
    std::string_view rest = description;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::size_t equals = line.find('=');
        if (equals == std::string_view::npos) continue;
        const std::string_view name = line.substr(0, equals);
        if (!is_our_name(name)) continue;
        metadata.emplace(one_line(name), one_line(line.substr(equals + 1)));
    }
}

}  // namespace

void put_metadata(OIIO::ImageSpec& spec, const Metadata& metadata, bool keeps_names) {
    std::string description;
    for (const auto& [name, value] : metadata) {
        if (keeps_names || !is_our_name(name)) {
            spec.attribute(name, one_line(value));
        } else {
            description += one_line(name) + "=" + one_line(value) + "\n";
        }
    }
    if (!description.empty()) spec.attribute(kDescription, description.substr(0, kMaxDescription));
}

Metadata metadata_of(const OIIO::ImageSpec& spec) {
    Metadata metadata;
    take_apart(std::string(spec.get_string_attribute(kDescription)), metadata);
    for (const OIIO::ParamValue& value : spec.extra_attribs) {
        const std::string text = value.get_string();
        metadata.emplace(one_line(value.name().string()),
                         one_line(std::string_view(text).substr(0, kMaxShown)));
    }
    return metadata;
}

}  // namespace burnish
