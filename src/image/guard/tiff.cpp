#include <fmt/format.h>

#include <optional>
#include <vector>

#include "image/guard/container_checks.hpp"

namespace burnish {
namespace {

constexpr std::uint64_t kTiffEntryBytes = 12;
constexpr unsigned kCfa = 32803, kLinearRaw = 34892;
constexpr std::uint64_t kMaxDirectories = 64, kMaxStrips = std::uint64_t{1} << 20;

// One entry of a directory: as many values of a type as it says, in place when they fit.
struct TiffEntry {
    unsigned type = 0;
    std::uint64_t count = 0, at = 0;  // `at`: where the value or its offset stands
};

// What this walk needs of a directory. Sizes of 0 are missing.
struct TiffDirectory {
    std::int64_t width = 0, height = 0, tile_width = 1, tile_height = 1;
    bool reduced = false;  // a smaller version of another picture of the file
    unsigned photometric = 0;
    std::uint64_t bits = 1, samples = 1;  // of a sample, of a pixel
    bool compressed = false;
    bool has_dng_version = false;
    TiffEntry offsets, lengths;         // of strips or tiles
    std::vector<std::uint64_t> others;  // offsets of directories that belong to it
    std::uint64_t next = 0;

    bool holds_sensor_data() const { return photometric == kCfa || photometric == kLinearRaw; }
};

class TiffWalk {
  public:
    explicit TiffWalk(const ByteCursor& file) : file_(file), big_(file.u8(0) == 'M') {}

    std::uint64_t first_offset() const { return file_.u32(4, big_); }

    std::uint64_t value(const TiffEntry& entry, std::uint64_t i) const {
        constexpr unsigned kByte = 1, kShort = 3;
        const std::uint64_t size = entry.type == kByte ? 1 : entry.type == kShort ? 2 : 4;
        const std::uint64_t from =
            entry.count * size <= 4 ? entry.at : std::uint64_t{file_.u32(entry.at, big_)};
        const std::uint64_t at = from + i * size;
        return size == 1 ? file_.u8(at) : size == 2 ? file_.u16(at, big_) : file_.u32(at, big_);
    }

    TiffDirectory directory_at(std::uint64_t offset) const {
        const unsigned entries = file_.u16(offset, big_);
        file_.require(offset + 2, std::uint64_t{entries} * kTiffEntryBytes);
        TiffDirectory directory;
        for (unsigned i = 0; i < entries; ++i)
            read_entry(offset + 2 + i * kTiffEntryBytes, directory);
        // The end of the last directory may be missing.
        const std::uint64_t next = offset + 2 + entries * kTiffEntryBytes;
        if (next + 4 <= file_.size()) directory.next = file_.u32(next, big_);
        return directory;
    }

    // Nothing for an offset outside the file or a directory cut short.
    std::optional<TiffDirectory> directory_if_whole(std::uint64_t offset) const {
        if (offset < 8 || offset + 2 > file_.size()) return std::nullopt;
        const std::uint64_t bytes = file_.u16(offset, big_) * kTiffEntryBytes;
        if (offset + 2 + bytes > file_.size()) return std::nullopt;
        return directory_at(offset);
    }

    // Throws when a strip or a tile of sensor data lies outside the file: decoders of raw files
    // fill what is missing.
    void check_sensor_data(const TiffDirectory& directory) const {
        check_image_size(directory.width, directory.height, file_.name());
        const std::uint64_t strips = std::min(directory.offsets.count, directory.lengths.count);
        if (strips > kMaxStrips) file_.fail(fmt::format("{} strips", strips));
        std::uint64_t bytes = 0;
        for (std::uint64_t i = 0; i < strips; ++i) {
            file_.require(value(directory.offsets, i), value(directory.lengths, i));
            bytes += value(directory.lengths, i);
        }
        const std::uint64_t wanted = static_cast<std::uint64_t>(directory.width) *
                                     static_cast<std::uint64_t>(directory.height) *
                                     directory.samples * directory.bits / 8;
        if (!directory.compressed && bytes < wanted)
            file_.fail(fmt::format("{} bytes of sensor data for {} x {} pixels", bytes,
                                   directory.width, directory.height));
    }

  private:
    void read_entry(std::uint64_t at, TiffDirectory& directory) const {
        constexpr unsigned kReducedBit = 1, kOldReduced = 2;
        const TiffEntry entry{file_.u16(at + 2, big_), file_.u32(at + 4, big_), at + 8};
        const auto number = [&] {
            return static_cast<std::int64_t>(value({entry.type, 1, at + 8}, 0));
        };
        switch (file_.u16(at, big_)) {
            case 254:
                directory.reduced |= (number() & kReducedBit) != 0;
                break;
            case 255:
                directory.reduced |= number() == kOldReduced;
                break;
            case 256:
                directory.width = number();
                break;
            case 257:
                directory.height = number();
                break;
            case 258:
                directory.bits = value(entry, 0);
                break;
            case 259:
                directory.compressed = number() != 1;
                break;
            case 277:
                directory.samples = static_cast<std::uint64_t>(number());
                break;
            case 262:
                directory.photometric = static_cast<unsigned>(number());
                break;
            case 273:
            case 324:
                directory.offsets = entry;
                break;
            case 279:
            case 325:
                directory.lengths = entry;
                break;
            case 322:
                directory.tile_width = number();
                break;
            case 323:
                directory.tile_height = number();
                break;
            case 330:
                read_others(entry, directory);
                break;
            case 50706:
                directory.has_dng_version = true;
                break;
            default:
                break;
        }
    }

    void read_others(const TiffEntry& entry, TiffDirectory& directory) const {
        const std::uint64_t count = std::min(entry.count, kMaxDirectories);
        const std::uint64_t from = entry.count == 1 ? entry.at : file_.u32(entry.at, big_);
        for (std::uint64_t i = 0; i < count && from + 4 * (i + 1) <= file_.size(); ++i)
            directory.others.push_back(file_.u32(from + 4 * i, big_));
    }

    const ByteCursor& file_;
    bool big_;
};

}  // namespace

void check_tiff(const ByteCursor& file) {
    const TiffWalk walk(file);
    const TiffDirectory first = walk.directory_at(walk.first_offset());
    check_image_size(first.width, first.height, file.name());
    check_image_size(first.tile_width, first.tile_height, file.name());
}

namespace {

// Files in which LibRaw finds the sensor data by what it knows of the maker.
bool is_of_a_maker(const ByteCursor& file) {
    constexpr std::uint64_t kCanonMark = 8;
    return has_raw_ending(file.name()) || file.text(kCanonMark, 2) == "CR";
}

}  // namespace

bool is_raw_tiff(const ByteCursor& file) {
    constexpr std::uint64_t kLeast = 10;
    if (file.size() < kLeast) return false;
    if (is_of_a_maker(file)) return true;
    const TiffWalk walk(file);
    const auto first = walk.directory_if_whole(walk.first_offset());
    if (!first) return false;
    if (first->holds_sensor_data() || first->has_dng_version) return true;
    if (first->reduced && (first->next != 0 || !first->others.empty())) return true;
    for (const std::uint64_t offset : first->others) {
        const auto other = walk.directory_if_whole(offset);
        if (other && other->holds_sensor_data()) return true;
    }
    return false;
}

void check_raw_tiff(const ByteCursor& file) {
    const TiffWalk walk(file);
    std::vector<std::uint64_t> waiting = {walk.first_offset()};
    bool is_raw = is_of_a_maker(file);
    for (std::uint64_t seen = 0; !waiting.empty() && seen < kMaxDirectories; ++seen) {
        const std::uint64_t offset = waiting.back();
        waiting.pop_back();
        const auto directory = walk.directory_if_whole(offset);
        if (!directory) {
            if (seen == 0) file.truncated();
            continue;  // makers' offsets are not all sound
        }
        if (directory->holds_sensor_data()) walk.check_sensor_data(*directory);
        is_raw |= directory->holds_sensor_data() || directory->has_dng_version;
        waiting.insert(waiting.end(), directory->others.begin(), directory->others.end());
        if (directory->next != 0) waiting.push_back(directory->next);
    }
    // LibRaw would take any picture of one channel for a mosaic.
    if (!is_raw)
        file.fail(
            "a TIFF with a preview before its picture: save the picture alone, or develop a raw "
            "camera file to a linear 16-bit TIFF");
}

}  // namespace burnish
