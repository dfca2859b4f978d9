// burnish capture export: a fitted material as maps for people and as a glTF for other programs
// (docs/reference/map-folders.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"

namespace burnish {

struct CaptureExportRequest {
    std::filesystem::path material;
    std::filesystem::path output;  // a folder, made when it is not there
    std::string command;           // for metadata
};

struct CaptureExportResult {
    std::vector<std::filesystem::path> written;  // material.gltf first
    std::vector<std::string> warnings;
};

// Writes all files or, when anything fails, none.
CaptureExportResult capture_export(const CaptureExportRequest& request, const Progress& progress);

}  // namespace burnish
