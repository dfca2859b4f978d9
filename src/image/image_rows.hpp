// Pictures of data that are written a strip at a time, so that a large one never needs to fit into
// memory.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace burnish {

enum class DataFormat {
    png16,      // values 0..1 as 16-bit codes, marked as linear data; 1 or 3 channels
    png8,       // the same as 8-bit codes
    png8_srgb,  // display values 0..1 as 8-bit codes: colors; 3 channels, or 4 with alpha
    exr         // 32-bit float, zip
};

struct DataLevel {
    int width = 0, height = 0;
    // Fills rows [begin, end), packed; called from one thread, from the top down.
    std::function<void(int begin, int end, float* to)> rows;
};

struct DataPicture {
    DataFormat format = DataFormat::exr;
    std::vector<std::string> channels;
    // The first level is the picture. Further levels, each half as wide and high as the one before
    // (rounded down, at least 1), make an .exr a mip map.
    std::vector<DataLevel> levels;
    std::map<std::string, std::string> metadata;
};

// Writes to `path`, every write checked; messages call it `name`. `step` is told the share of rows
// done and may throw. For use inside write_file_whole: what fails leaves a part of a file.
void write_data_picture(const std::filesystem::path& path, const DataPicture& picture,
                        const std::string& name, const std::function<void(double)>& step);

}  // namespace burnish
