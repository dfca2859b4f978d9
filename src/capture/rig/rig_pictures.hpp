// The pictures of a rig: found by the names that its file has, or taken by their order. Private to
// src/capture/rig and the jobs of captures.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/rig.hpp"
#include "core/find_file.hpp"

namespace burnish::rig_reading {

// Endings of all pictures that a rig may have.
std::span<const std::string_view> all_endings();

// Finds pictures in a folder by names of other machines (find_file.hpp), and remembers which
// differ and which are missing.
class PictureFinder {
  public:
    struct Named {
        std::string where, name;  // of the rig's file
        FoundFile found;          // empty: missing
        std::filesystem::path path;
    };

    explicit PictureFinder(const std::filesystem::path& folder)
        : folder_(folder), finder_(folder, {all_endings(), {}, true}) {}

    // The path of a light's picture; that which the name says if there is none.
    std::filesystem::path find(const std::string& where, const std::string& name);
    // The same of a mask or a flat field, which are not counted with the lights' pictures.
    std::filesystem::path find_aside(const std::string& where, const std::string& name);

    std::size_t count() const { return count_; }                  // of the lights' pictures
    const std::vector<Named>& others() const { return others_; }  // found under another name
    const std::vector<Named>& missing() const { return missing_; }
    const std::vector<Named>& missing_aside() const { return missing_aside_; }

  private:
    std::filesystem::path find(const std::string& where, const std::string& name,
                               std::vector<Named>& missing);

    std::filesystem::path folder_;
    FileFinder finder_;
    std::size_t count_ = 0;
    std::vector<Named> others_, missing_, missing_aside_;
};

// One warning for all pictures that were found under another name; none if there are none.
void warn_of_others(const PictureFinder& finder, std::vector<std::string>& warnings);

// With `skip_missing`, leaves out missing pictures and lights without any, unless all are missing.
// Else throws Error that says how many are missing and which flag helps; a rig that needs no
// pictures keeps their names.
void settle_missing(const PictureFinder& finder, bool needs_images, bool skip_missing, Rig& rig);

// Gives the pictures beside the rig's file to its lights, both in order. Throws Error for another
// number of pictures; a rig that needs none keeps what it has then.
void take_by_order(bool needs_images, Rig& rig);

}  // namespace burnish::rig_reading
