// The editor turns documents into a stage, and does again only what differs.
//
// Threads: one at a time for each object. Lifetime: an editor owns its stage; references stay good
// until the next change.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/stage.hpp"
#include "viewer/document/document.hpp"
#include "viewer/document/history.hpp"

namespace burnish::viewer {

// Counters that grow when a part of the stage changes: what a renderer has to upload again.
struct Revisions {
    std::uint64_t scene = 0;     // everything was loaded anew: all others grow too
    std::uint64_t geometry = 0;  // meshes (appended or with new tangents) or instances
    std::uint64_t materials = 0;
    // Textures were appended, or their places emptied or assigned anew: stage().materials
    // .texture_changes() counts that for each place.
    std::uint64_t textures = 0;
    std::uint64_t lights = 0;
    std::uint64_t environment = 0;  // its radiance; intensity and rotation are settings
    std::uint64_t camera = 0;
    std::uint64_t settings = 0;  // Stage::settings
    std::uint64_t display = 0;   // exposure, tone map, robust mean
    bool operator==(const Revisions&) const = default;
};

// Every function that changes the document gives the strong guarantee: when it throws, document,
// stage, history and revisions are what they were. They throw UsageError for values that contradict
// each other, Error for files that cannot be read.
class Editor {
  public:
    Editor() = default;  // an empty document, and a stage with an empty scene

    const Document& document() const { return history_.present(); }
    const Stage& stage() const { return stage_; }
    const Revisions& revisions() const { return revisions_; }
    const History& history() const { return history_; }

    // What is drawn otherwise than the document asks, one line each: all lines that are true now, and
    // those of them that the last change brought.
    const std::vector<std::string>& warnings() const { return stage_.scene.warnings; }
    const std::vector<std::string>& new_warnings() const { return new_warnings_; }

    // Loads the document and forgets the history. What the document leaves empty is taken from the
    // input (with_state_of_input).
    void open(Document document, const Progress& progress = {});
    // The same with a stage that load_stage has made of this document, perhaps on another thread.
    void open_loaded(Document document, Stage stage);

    // Makes the document the present one, as a step of the history (History::record). An input that
    // differs (needs_load) is read by the calling thread.
    void set(Document document, std::string_view key = {}, std::string_view name = {});
    // The same with a stage that load_stage has made of it.
    void set_loaded(Document document, Stage stage, std::string_view name = {});
    // Maps of a folder that were read on another thread, before a document that is set names it.
    void put_scratch(const std::string& name, ScratchTextures textures) {
        stage_.materials.put_scratch(name, std::move(textures));
    }
    // The objects of a material are drawn with another one of the scene, which the document does not say: for
    // the second picture of a comparison. It ends when the input is read anew. Throws std::out_of_range for an
    // index without a material.
    void put_in_place(int material, int other);
    void close_step() { history_.close(); }  // at the end of a drag

    // False: there is nothing to undo. They may have to read the input anew: see needs_load of
    // history().undo_document(), and the forms that take a loaded stage.
    bool undo();
    bool redo();
    bool undo_loaded(Stage stage);
    bool redo_loaded(Stage stage);

    // Width over height of the picture that is shown: a camera that neither document nor input states
    // frames the scene in it. At first that of the settings.
    void set_aspect(double aspect);
    std::optional<double> aspect() const { return aspect_; }
    // The camera of a picture of another shape.
    Camera camera_of(double aspect);

    // Files have changed on disk: reads everything that the document names again.
    void reload(const Progress& progress = {});
    void reloaded(Stage stage);

  private:
    struct Change;
    Change change_to(const Document& document) const;
    void adopt(Stage stage);
    void go_to(const Document& document);
    void update_to(const Document& document);
    void apply_materials(const Document& document, const ParameterValues& values);
    void replace_warnings();

    History history_;
    Stage stage_;
    Revisions revisions_;
    std::optional<double> aspect_;
    std::vector<std::string> new_warnings_;
    std::vector<std::pair<int, bool>> checked_normal_maps_;  // texture, flip_green
};

}  // namespace burnish::viewer
