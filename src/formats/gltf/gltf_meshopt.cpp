#include "formats/gltf/gltf_meshopt.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include "burnish/error.hpp"

namespace burnish {
namespace {

enum class Mode { attributes, triangles, indices };

Mode mode_of(const MeshoptView& view, std::string_view key, const GltfReport& report) {
    if (view.mode == "ATTRIBUTES") return Mode::attributes;
    if (view.mode == "TRIANGLES") return Mode::triangles;
    if (view.mode == "INDICES") return Mode::indices;
    report.fail(fmt::format("{}.mode", key), "ATTRIBUTES, TRIANGLES or INDICES", shown(view.mode));
}

// Checks the combination of mode, stride and filter against the extension's table.
void check_layout(const MeshoptView& view, Mode mode, std::string_view key,
                  const GltfReport& report) {
    const std::size_t stride = view.stride;
    const std::string found = fmt::format("byteStride {}, count {}, mode {}, filter {}", stride,
                                          view.count, view.mode, shown(view.filter));
    if (mode == Mode::attributes) {
        if (stride == 0 || stride % 4 != 0 || stride > 256)
            report.fail(key, "a byteStride of 4, 8 .. 256", found);
    } else {
        if (stride != 2 && stride != 4) report.fail(key, "a byteStride of 2 or 4", found);
        if (view.filter != "NONE") report.fail(key, "no filter for indices", found);
        if (mode == Mode::triangles && view.count % 3 != 0)
            report.fail(key, "a count divisible by 3", found);
    }
    const bool known = view.filter == "NONE" || view.filter == "EXPONENTIAL" ||
                       (view.filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
                       (view.filter == "QUATERNION" && stride == 8);
    if (!known)
        report.fail(key, "filter NONE, OCTAHEDRAL (4 or 8 bytes), QUATERNION (8) or EXPONENTIAL",
                    found);
}

// Largest number of elements that `bytes` can encode, which bounds the count before memory is
// allocated. One byte encodes at most 64 bytes of attributes (2 bits of header for 16 equal bytes),
// three 4-byte indices of a triangle, or one index.
std::size_t most_unpacked(Mode mode, std::size_t bytes, std::size_t stride) {
    switch (mode) {
        case Mode::attributes:
            return 64 * bytes;
        case Mode::triangles:
            return 3 * stride * bytes;
        case Mode::indices:
            return stride * bytes;
    }
    return 0;
}

int decode(Mode mode, const MeshoptView& view, std::vector<std::byte>& out) {
    const auto* source = reinterpret_cast<const unsigned char*>(view.bytes.data());
    switch (mode) {
        case Mode::attributes:
            return meshopt_decodeVertexBuffer(out.data(), view.count, view.stride, source,
                                              view.bytes.size());
        case Mode::triangles:
            return meshopt_decodeIndexBuffer(out.data(), view.count, view.stride, source,
                                             view.bytes.size());
        case Mode::indices:
            return meshopt_decodeIndexSequence(out.data(), view.count, view.stride, source,
                                               view.bytes.size());
    }
    return -1;
}

void apply_filter(const MeshoptView& view, std::vector<std::byte>& out) {
    if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), view.count, view.stride);
    if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), view.count, view.stride);
    if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), view.count, view.stride);
}

}  // namespace

std::vector<std::byte> decode_meshopt_view(const MeshoptView& view, std::string_view key,
                                           GltfReport& report) {
    const Mode mode = mode_of(view, key, report);
    check_layout(view, mode, key, report);
    const std::size_t length = view.count * view.stride;  // both below 2^31: no overflow
    if (length > most_unpacked(mode, view.bytes.size(), view.stride)) {
        report.fail(fmt::format("{}.count", key), "no more than the compressed bytes can hold",
                    fmt::format("{} in {} bytes", view.count, view.bytes.size()));
    }
    report.pay(length, key);
    std::vector<std::byte> out(length);
    if (view.count == 0) return out;
    if (const int code = decode(mode, view, out); code != 0)
        report.fail(key, "meshopt data", fmt::format("corrupt data (error {})", code));
    apply_filter(view, out);
    return out;
}

}  // namespace burnish
