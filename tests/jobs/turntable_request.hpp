// Requests of small turntables for tests.
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

#include "burnish/image.hpp"
#include "burnish/image_io.hpp"
#include "burnish/render.hpp"
#include "jobs/render.hpp"

namespace burnish::test {

// 64 x 48 pixels, quick. The camera stands: the view of a still is that of a turn.
inline RenderRequest turntable_request(
    const std::string& input, const std::filesystem::path& output, int count,
    std::initializer_list<std::pair<const char*, const char*>> more = {}) {
    RenderRequest request;
    request.stage.input = input;
    request.output = output;
    request.turntable = count;
    const bool builtin = input.starts_with("builtin:");
    if (builtin) request.stage.values.set("triangles", "4000", "");
    for (const auto& [name, text] : {std::pair{"width", "64"},
                                     {"height", "48"},
                                     {"samples", "4"},
                                     {"image_light_samples", "4"},
                                     {"camera_distance", "3"},
                                     {"camera_target", "0,0,0"}})
        request.stage.values.set(name, text, name);
    for (const auto& [name, text] : more) request.stage.values.set(name, text, name);
    return request;
}

inline Image frame_picture(const RenderRequest& request, int index) {
    return read_image(numbered(request.output, index));
}

}  // namespace burnish::test
