// .obj with its .mtl: what follows the line "#mtl" is the material library `model.mtl`.
#include <string_view>

#include "formats/obj/obj.hpp"
#include "harness.hpp"
#include "scene_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using burnish::fuzz::Bytes;
    constexpr std::string_view kMark = "\n#mtl\n";
    const Bytes all(data, size);
    const std::size_t mark =
        std::string_view(reinterpret_cast<const char*>(data), size).find(kMark);
    const bool split = mark != std::string_view::npos;
    const auto path = burnish::fuzz::put("model.obj", split ? all.first(mark) : all);
    burnish::fuzz::put("model.mtl", split ? all.subspan(mark + kMark.size()) : Bytes());
    burnish::fuzz::expect_answer([&] { burnish::fuzz::expect_sound(burnish::load_obj(path)); });
    return 0;
}
