// burnish capture export: writes a fitted material as maps for viewing and as glTF for other
// programs (docs/reference/map-folders.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"

namespace burnish {

struct CaptureExportRequest {
    std::filesystem::path material;
    std::filesystem::path output;  // a folder, created if it is missing
    std::string command;           // for metadata
};

struct CaptureExportResult {
    std::vector<std::filesystem::path> written;  // material.gltf first
    std::vector<std::string> warnings;
};

// Writes all files, or none if anything fails.
CaptureExportResult capture_export(const CaptureExportRequest& request, const Progress& progress);

}  // namespace burnish
