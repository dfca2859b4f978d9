// `burnish info`: what a model, scene, image, environment, measured material, draft or rig holds,
// in lines for a person.
#pragma once

#include <string>

namespace burnish {

// Several lines, each ended by a newline. Throws Error when the file is none of ours or is broken.
std::string describe_file(const std::string& path_or_builtin);

// The devices EGL offers, one line each, with the index that --gl-device takes.
std::string describe_devices();

}  // namespace burnish
