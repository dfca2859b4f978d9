// The second document of a comparison: what was held as "before", or the scene with another material.
//
// Threads: functions may be called from any thread. Lifetime: values refer to nothing else.
#pragma once

#include "viewer/document/document.hpp"
#include "viewer/document/editor.hpp"

namespace burnish::viewer {

// `held` under the camera, the lights, the environment and the settings of `now`.
Document seen_as(const Document& held, const Document& now);

// The scene in which the objects of a material have another one.
class OtherMaterial {
  public:
    // Reads what a file is. Throws Error for a file that is no material, and for indices without a
    // material in the scene of `now`.
    OtherMaterial(const Editor& now, MaterialPair pair);

    const MaterialPair& pair() const { return pair_; }
    // An editor of the scene with the other material, to be kept beside that of the scene as it is.
    Editor editor_of(const Editor& now) const;
    // The document that such an editor is to be given when the scene's becomes `now`.
    Document of(const Document& now) const;
    // Of the pictures, first and second.
    const std::string& first_name() const { return names_[0]; }
    const std::string& second_name() const { return names_[1]; }

  private:
    MaterialPair pair_;
    ParameterValues file_values_;  // by which the file is put onto a material
    std::string names_[2];
};

// The material's name, else "#3".
std::string material_name(const Scene& scene, int index);

}  // namespace burnish::viewer
