// `burnish info`: the contents of a model, scene, image, environment, measured material, draft or
// rig, as text lines.
#pragma once

#include <string>

namespace burnish {

// Several lines, each ended by a newline. Throws Error if the file is of no known kind or is
// broken.
std::string describe_file(const std::string& path_or_builtin);

// The devices that EGL offers, one line each, with the index for --gl-device.
std::string describe_devices();

}  // namespace burnish
