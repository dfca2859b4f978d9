// .gltf and .glb. A .glb carries its own lengths, which bytes changed at random would break before
// anything else is looked at: the mutator takes the file apart and puts it together again.
#include <algorithm>
#include <cstring>
#include <vector>

#include "formats/gltf/gltf.hpp"
#include "harness.hpp"
#include "scene_check.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using burnish::fuzz::Bytes;
using Buffer = std::vector<std::uint8_t>;

constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBinary = 0x004E4942;

std::uint32_t word(Bytes bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

void append_word(Buffer& out, std::size_t value) {
    for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>((value >> (8 * i)) & 0xFF));
}

struct Parts {
    Buffer json, binary;
};

// False for what is no .glb with one JSON chunk.
bool take_apart(Bytes file, Parts& parts) {
    if (file.size() < kHeader + kChunkHeader || word(file, 0) != kMagic) return false;
    Bytes rest = file.subspan(kHeader + kChunkHeader);
    const std::size_t json = word(file, kHeader);
    if (json > rest.size() || word(file, kHeader + 4) != kJson) return false;
    parts.json.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(json));
    rest = rest.subspan(json);
    if (rest.size() > kChunkHeader) rest = rest.subspan(kChunkHeader);
    parts.binary.assign(rest.begin(), rest.end());
    return true;
}

Buffer put_together(Parts parts) {
    while (parts.json.size() % 4 != 0) parts.json.push_back(' ');
    while (parts.binary.size() % 4 != 0) parts.binary.push_back(0);
    Buffer out;
    append_word(out, kMagic);
    append_word(out, 2);
    append_word(out, kHeader + 2 * kChunkHeader + parts.json.size() + parts.binary.size());
    append_word(out, parts.json.size());
    append_word(out, kJson);
    out.insert(out.end(), parts.json.begin(), parts.json.end());
    append_word(out, parts.binary.size());
    append_word(out, kBinary);
    out.insert(out.end(), parts.binary.begin(), parts.binary.end());
    return out;
}

void mutate(Buffer& part, std::size_t room) {
    const std::size_t size = part.size();
    part.resize(size + room);
    part.resize(LLVMFuzzerMutate(part.data(), size, part.size()));
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
    Parts parts;
    // One in eight stays raw, for the container's own checks.
    if (seed % 8 == 0 || !take_apart(Bytes(data, size), parts))
        return LLVMFuzzerMutate(data, size, most);
    const std::size_t room = most > size + kChunkHeader ? (most - size - kChunkHeader) / 2 : 0;
    mutate(seed % 4 == 1 && !parts.binary.empty() ? parts.binary : parts.json, room);
    const Buffer out = put_together(parts);
    if (out.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::copy(out.begin(), out.end(), data);
    return out.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = burnish::fuzz::put("model.gltf", Bytes(data, size));
    burnish::fuzz::expect_answer([&] { burnish::fuzz::expect_sound(burnish::load_gltf(path)); });
    return 0;
}
