// The second picture of a comparison: of the scene as it was held, or with another material, under the
// present camera, lights and settings.
//
// Threads: the one on which the window's context is current. Lifetime: destroy it before the context.
#pragma once

#include <cstdint>
#include <optional>

#include "viewer/document/second_document.hpp"
#include "viewer/window/picture.hpp"

namespace burnish::viewer {

class SecondPicture {
  public:
    // Of the scene as it is now: the "before" of what comes.
    SecondPicture(gpu::Context& context, const Editor& now);
    // Of the scene with another material. Throws Error where there is none.
    SecondPicture(gpu::Context& context, const Editor& now, const MaterialPair& pair);

    // Takes over what belongs to both pictures. Throws Error.
    void follow(const Editor& now);

    bool is_before() const { return !other_; }
    // Of the pictures as they stand in a comparison: "before" is the first, another material the second.
    std::string first_name() const { return other_ ? other_->first_name() : "before"; }
    std::string second_name() const { return other_ ? other_->second_name() : "now"; }

    Picture picture;

  private:
    std::optional<OtherMaterial> other_;
    Editor editor_;
};

}  // namespace burnish::viewer
