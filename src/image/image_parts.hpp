// OpenEXR files of several parts, each a picture of named channels. Tables and maps that belong
// together are one file, which any viewer of OpenEXR shows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

struct ImageChannel {
    std::string name;
    bool half = false;          // stored with 11 bits; else as float
    std::vector<float> values;  // width x height, row 0 at the top
};

struct ImagePart {
    std::string name;
    int width = 0, height = 0;
    std::vector<ImageChannel> channels;
    std::map<std::string, int> integers;  // attributes
    std::map<std::string, double> reals;
    std::map<std::string, std::string> texts;  // of one line

    const ImageChannel* find(std::string_view channel) const;
};

// All parts, in order; channels as floats, whatever their type, NaN and infinities as they are.
// Throws Error naming the file for missing, truncated, hostile and huge files (a side over 32768,
// over 4 GiB decoded in all, more than 64 parts or 64 channels).
std::vector<ImagePart> read_image_parts(const std::filesystem::path& path);

// Written whole or not at all. Names of parts and of their channels differ.
void write_image_parts(const std::filesystem::path& path, const std::vector<ImagePart>& parts);

// Whether the file is OpenEXR and its first header has an integer attribute of that name. Decodes
// no pixel.
bool has_image_part_attribute(const std::filesystem::path& path, std::string_view name);

}  // namespace burnish
