// A folder of maps of one surface, the output of `burnish scratch` and `burnish weave`. It is
// written completely or not at all.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "core/files.hpp"
#include "image/image_rows.hpp"

namespace burnish {

// Creates the folder if it is missing and removes it again if it stays empty. Throws Error if
// `path` is not a folder or has no parent folder.
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

// Writes `others` and the pictures into `folder`, all with `metadata`. The first of `others` is
// renamed to its final name last: if it exists, so do the maps of its run. Returns the paths. If
// `progress` throws, the previous files stay.
std::vector<std::filesystem::path> write_map_folder(
    const std::filesystem::path& folder, std::vector<FileToWrite> others,
    std::vector<NamedPicture> pictures, const std::map<std::string, std::string>& metadata,
    const Progress& progress);

}  // namespace burnish
