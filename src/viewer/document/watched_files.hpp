// The files that a document is made of, and what happens to them on disk while it is open.
//
// Threads: one at a time for each object. Lifetime: what functions return refers to nothing else.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"

namespace burnish::viewer {

// Files and folders that the document and its scene file name, each once: models, environments, maps,
// materials. `stage`: of this document.
std::vector<std::string> files_of(const Document& document, const Stage& stage);

class WatchedFiles {
  public:
    struct Changes {
        bool changed = false;           // a file has another time than at the last look
        std::vector<std::string> gone;  // since the last look
        std::vector<std::string> back;  // were missing at the last look
    };
    // Looks at the files on disk. A file that was not among those of the last look has not changed; it
    // is gone where it does not exist. Never throws.
    Changes look(const std::vector<std::string>& files);
    // Those that did not exist at the last look.
    std::vector<std::string> missing() const;

  private:
    // None: it does not exist.
    std::map<std::string, std::optional<std::filesystem::file_time_type>> known_;
};

// "part.glb is gone from disk: what was read stays"; "" for no files.
std::string line_of_missing(const std::vector<std::string>& files);

}  // namespace burnish::viewer
