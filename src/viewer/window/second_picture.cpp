#include "viewer/window/second_picture.hpp"

namespace burnish::viewer {

SecondPicture::SecondPicture(gpu::Context& context, const Editor& now)
    : picture(context), editor_(now) {}

SecondPicture::SecondPicture(gpu::Context& context, const Editor& now, const MaterialPair& pair)
    : picture(context), other_(OtherMaterial(now, pair)), editor_(other_->editor_of(now)) {}

void SecondPicture::follow(const Editor& now) {
    if (now.aspect()) editor_.set_aspect(*now.aspect());
    editor_.set(other_ ? other_->of(now.document()) : seen_as(editor_.document(), now.document()),
                "follow");
    picture.follow(editor_);
}

}  // namespace burnish::viewer
