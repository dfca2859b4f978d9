#include "harness.hpp"

#include <oneapi/tbb/global_control.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "burnish/error.hpp"
#include "burnish/image.hpp"
#include "burnish/image_io.hpp"

namespace burnish::fuzz {
namespace {

namespace fs = std::filesystem;

Bytes bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void write(const fs::path& path, Bytes bytes) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
    if (!file) broken("the harness cannot write its own file");
}

constexpr std::string_view kObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
constexpr std::string_view kGltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,)"
    R"("camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}],"cameras":[{"type":)"
    R"("perspective","perspective":{"yfov":1,"znear":0.1}}],"extensions":{"KHR_lights_punctual":)"
    R"({"lights":[{"type":"spot","spot":{}}]}},"extensionsUsed":["KHR_lights_punctual"],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":)"
    R"("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";

fs::path make_folder() {
    // One thread: the same input takes the same way, and the time is one core's.
    static const oneapi::tbb::global_control one_thread(
        oneapi::tbb::global_control::max_allowed_parallelism, 1);
    const fs::path memory = "/dev/shm";
    const fs::path parent = fs::is_directory(memory) ? memory : fs::temp_directory_path();
    const fs::path made = parent / ("burnish-fuzz-" + std::to_string(::getpid()));
    fs::create_directory(made);
    std::atexit([] {
        std::error_code ignored;
        fs::remove_all(folder(), ignored);
    });
    write_image(made / "map.png", Image(4, 4, 3, 0.5f), {});
    write_image(made / "sky.exr", Image(8, 4, 3, 1.0f), {});
    write(made / "part.obj", bytes_of(kObj));
    write(made / "part.gltf", bytes_of(kGltf));
    return made;
}

}  // namespace

const fs::path& folder() {
    static const fs::path made = make_folder();
    return made;
}

fs::path put(std::string_view name, Bytes bytes) {
    fs::path path = folder() / name;
    write(path, bytes);
    return path;
}

void expect_answer(const std::function<void()>& read) {
    try {
        read();
    } catch (const Error& error) {
        const std::string_view line = error.what();
        if (line.empty()) broken("an error without words");
        if (line.find_first_of("\r\n") != std::string_view::npos) broken("an error of two lines");
    }
}

void broken(std::string_view what) {
    std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(what.size()), what.data());
    std::abort();
}

}  // namespace burnish::fuzz
