#include <algorithm>

#include "image/guard/container_checks.hpp"

namespace burnish {

// Needed until OpenImageIO passes on what LibRaw finds missing: 2.4 fills it with black.
void check_raw(const ByteCursor& file) {
    constexpr std::uint64_t kFujiData = 100;  // offset and length of the sensor data
    const std::string_view head = file.text(0, std::min<std::uint64_t>(file.size(), 16));
    if (head.starts_with("FUJIFILM"))
        return file.require(file.u32(kFujiData, kBigEndian), file.u32(kFujiData + 4, kBigEndian));
    if (head.size() >= 8 && head.substr(4, 4) == "ftyp") return check_boxes(file);
    if (head.starts_with("II*") || head.starts_with("MM")) check_raw_tiff(file);
}

}  // namespace burnish
