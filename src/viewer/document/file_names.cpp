#include "viewer/document/file_names.hpp"

#include "burnish/builtin_meshes.hpp"

namespace burnish::viewer {

namespace fs = std::filesystem;

fs::path real_folder(const fs::path& folder) {
    std::error_code error;
    const fs::path absolute = fs::absolute(folder);
    const fs::path real = fs::weakly_canonical(absolute, error);
    return error ? absolute : real;
}

std::string absolute_name(const std::string& path) {
    if (is_builtin(path) || path.empty()) return path;
    fs::path file = fs::absolute(path);
    if (!file.has_filename()) file = file.parent_path();  // "folder/"
    if (file.filename() == "." || file.filename() == "..") return real_folder(file).string();
    return (real_folder(file.parent_path()) / file.filename()).string();
}

}  // namespace burnish::viewer
