#include "formats/gltf/gltf_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/error.hpp"

namespace burnish {

void GltfReport::fail(std::string_view key, std::string_view expected,
                      std::string_view found) const {
    throw Error(file_, key, expected, found);
}

void GltfReport::warn(std::string line) {
    line = one_line(line);  // names in the file may hold any characters
    if (std::find(warnings_.begin(), warnings_.end(), line) != warnings_.end()) return;
    if (warnings_.size() < kMostWarnings)
        warnings_.push_back(std::move(line));
    else
        ++more_warnings_;
}

std::vector<std::string> GltfReport::take_warnings() {
    if (more_warnings_ > 0) warnings_.push_back(fmt::format("{} more warnings", more_warnings_));
    return std::move(warnings_);
}

void GltfReport::earn(std::uint64_t file_bytes) {
    credit_ += kCreditPerByte * file_bytes;
}

void GltfReport::pay(std::uint64_t bytes, std::string_view key) {
    if (bytes > credit_) {
        fail(key, fmt::format("at most {} MiB more, in proportion to the file", credit_ >> 20),
             fmt::format("{} MiB", bytes >> 20));
    }
    credit_ -= bytes;
}

}  // namespace burnish
