// The extensions of glTF that burnish knows, and what a picture shows of each. The table in
// docs/reference/gltf.md is held against this list by a test.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/gltf/gltf_report.hpp"

namespace burnish {

enum class GltfSupport {
    drawn,
    approximated,
    ignored,   // with a warning; refused where the file requires it
    harmless,  // nothing to draw: passed over
};

struct GltfExtension {
    std::string_view name;
    GltfSupport support = GltfSupport::drawn;
    std::string_view effect = {};  // approximated: how; ignored: what is drawn instead
    std::string_view remedy = {};  // ignored: how to make a file that is drawn; may be empty
    bool of_textures = false;      // ignored: each texture that has it is warned of by itself
};

std::span<const GltfExtension> gltf_extensions();

// Whether the reader looks at the objects of this extension.
bool is_gltf_extension_read(std::string_view name);

// Throws Error for an ignored or unknown required extension; warns once for each other one.
void check_gltf_extensions(const std::vector<std::string>& used,
                           const std::vector<std::string>& required, GltfReport& report);

// How to convert the textures of an extension that is not read; empty when nothing is known.
std::string_view gltf_extension_remedy(std::string_view name);

}  // namespace burnish
