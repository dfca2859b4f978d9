// A folder of maps of one surface, written whole or not at all: what `burnish scratch` and `burnish
// weave` make.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "core/files.hpp"
#include "image/image_rows.hpp"

namespace burnish {

// The folder, made when it is not there and removed again when nothing came into it. Throws Error
// when `path` is something else or has no folder to lie in.
class OutputFolder {
  public:
    explicit OutputFolder(const std::filesystem::path& path);
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;
    ~OutputFolder();

  private:
    std::filesystem::path path_;
    bool made_ = false;
};

struct NamedPicture {
    std::string name;  // of the file
    DataPicture picture;
};

extern const std::vector<std::string> kRgb;

// A picture without a mip map.
DataPicture picture_of_rows(DataFormat format, std::vector<std::string> channels, int width,
                            int height, std::function<void(int begin, int end, float* to)> rows);

// Writes `others` and the pictures into `folder`, all with `metadata`. The first of `others` gets
// its name last: where it is, the maps of the same run are. Returns the paths. Interrupted by what
// `progress` throws it leaves what was there before.
std::vector<std::filesystem::path> write_map_folder(
    const std::filesystem::path& folder, std::vector<FileToWrite> others,
    std::vector<NamedPicture> pictures, const std::map<std::string, std::string>& metadata,
    const Progress& progress);

}  // namespace burnish
