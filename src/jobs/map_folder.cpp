#include "jobs/map_folder.hpp"

#include <fmt/format.h>

#include <utility>

#include "burnish/error.hpp"

namespace burnish {

namespace fs = std::filesystem;

OutputFolder::OutputFolder(const fs::path& path) : path_(path) {
    std::error_code error;
    made_ = fs::create_directory(path, error);
    if (const bool failed = static_cast<bool>(error); failed || !fs::is_directory(path, error))
        throw Error(path.string(), "", "a folder, or a name for one in a folder that is there",
                    fs::exists(path) ? "something else" : one_line(error.message()));
}

OutputFolder::~OutputFolder() {
    std::error_code error;
    if (made_) fs::remove(path_, error);  // fails if the folder is not empty
}

const std::vector<std::string> kRgb = {"R", "G", "B"};

DataPicture picture_of_rows(DataFormat format, std::vector<std::string> channels, int width,
                            int height, std::function<void(int begin, int end, float* to)> rows) {
    return {format, std::move(channels), {{width, height, std::move(rows)}}, {}};
}

std::vector<fs::path> write_map_folder(const fs::path& folder, std::vector<FileToWrite> others,
                                       std::vector<NamedPicture> pictures,
                                       const std::map<std::string, std::string>& metadata,
                                       const Progress& progress) {
    std::vector<FileToWrite> files = std::move(others);
    for (NamedPicture& named : pictures) {
        named.picture.metadata = metadata;
        const fs::path name = folder / named.name;
        files.push_back({name, [&named, &progress, name](const fs::path& path) {
                             const std::string stage = fmt::format("write {}", named.name);
                             write_data_picture(path, named.picture, name.string(),
                                                [&](double done) { progress.step(stage, done); });
                         }});
    }
    write_files_whole(files);
    std::vector<fs::path> written;
    written.reserve(files.size());
    for (const FileToWrite& file : files) written.push_back(file.path);
    return written;
}

}  // namespace burnish
