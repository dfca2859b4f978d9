#include "support/dng_writer.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace burnish::test {
namespace {

constexpr int kPreviewWidth = 16, kPreviewHeight = 12;

// Types of TIFF entries.
constexpr std::uint16_t kByte = 1, kAscii = 2, kShort = 3, kLong = 4, kRational = 5,
                        kSignedRational = 10;

using Bytes = std::vector<std::byte>;

void put(Bytes& to, std::uint64_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to.push_back(static_cast<std::byte>(value >> 8 * i));
}

// A directory whose values are written behind it, little-endian.
class TiffDirectory {
  public:
    void add(std::uint16_t tag, std::uint16_t type, const std::vector<std::uint32_t>& numbers) {
        const std::size_t size = type == kByte ? 1 : type == kShort ? 2 : 4;
        Bytes value;
        for (const std::uint32_t number : numbers) put(value, number, size);
        const std::size_t parts = type == kRational || type == kSignedRational ? 2 : 1;
        entries_.push_back({tag, type, numbers.size() / parts, std::move(value)});
    }
    void add(std::uint16_t tag, const std::string& text) {
        Bytes value;
        for (const char c : text + '\0') value.push_back(static_cast<std::byte>(c));
        entries_.push_back({tag, kAscii, value.size(), std::move(value)});
    }
    void add_rationals(std::uint16_t tag, std::uint16_t type, std::span<const double> numbers) {
        constexpr double kScale = 10000.0;
        std::vector<std::uint32_t> pairs;
        for (const double number : numbers) {
            pairs.push_back(static_cast<std::uint32_t>(std::lround(number * kScale)));
            pairs.push_back(static_cast<std::uint32_t>(kScale));
        }
        add(tag, type, pairs);
    }

    // Bytes of the directory and its values.
    std::size_t size() const {
        std::size_t total = 2 + 12 * entries_.size() + 4;
        for (const Entry& entry : entries_)
            if (entry.value.size() > 4) total += padded(entry.value.size());
        return total;
    }

    void write(Bytes& to) {
        std::sort(entries_.begin(), entries_.end(),
                  [](const Entry& a, const Entry& b) { return a.tag < b.tag; });
        std::size_t behind = to.size() + 2 + 12 * entries_.size() + 4;
        Bytes values;
        put(to, entries_.size(), 2);
        for (const Entry& entry : entries_) {
            put(to, entry.tag, 2);
            put(to, entry.type, 2);
            put(to, entry.count, 4);
            Bytes value = entry.value;
            value.resize(std::max<std::size_t>(4, padded(value.size())));
            if (entry.value.size() <= 4) {
                to.insert(to.end(), value.begin(), value.end());
            } else {
                put(to, behind, 4);
                behind += value.size();
                values.insert(values.end(), value.begin(), value.end());
            }
        }
        put(to, 0, 4);  // no further directory
        to.insert(to.end(), values.begin(), values.end());
    }

  private:
    struct Entry {
        std::uint16_t tag, type;
        std::size_t count;
        Bytes value;
    };
    static std::size_t padded(std::size_t size) { return (size + 1) / 2 * 2; }
    std::vector<Entry> entries_;
};

void add_camera(TiffDirectory& directory, const DngSettings& settings) {
    // Of a made-up camera: close to XYZ of sRGB primaries.
    constexpr double kColorMatrix[] = {0.9, -0.3, -0.1, -0.4, 1.3, 0.1, -0.1, 0.2, 0.7};
    constexpr std::uint32_t kDaylight = 21;
    directory.add(271, "Tests");
    directory.add(272, settings.model);
    directory.add(274, kShort, {settings.orientation});
    if (settings.says_dng) {
        directory.add(50706, kByte, {1, 4, 0, 0});
        directory.add(50708, "Tests " + settings.model);
        directory.add_rationals(50721, kSignedRational, kColorMatrix);
        directory.add_rationals(50728, kRational, settings.as_shot_neutral);
        directory.add(50778, kShort, {kDaylight});
    }
}

void add_preview(TiffDirectory& directory, std::size_t pixels_at) {
    directory.add(254, kLong, {1});
    directory.add(256, kLong, {kPreviewWidth});
    directory.add(257, kLong, {kPreviewHeight});
    directory.add(258, kShort, {8, 8, 8});
    directory.add(259, kShort, {1});
    directory.add(262, kShort, {2});
    directory.add(273, kLong, {static_cast<std::uint32_t>(pixels_at)});
    directory.add(277, kShort, {3});
    directory.add(278, kLong, {kPreviewHeight});
    directory.add(279, kLong, {kPreviewWidth * kPreviewHeight * 3});
}

void add_sensor(TiffDirectory& directory, int width, int height, std::size_t samples_at,
                const DngSettings& settings) {
    const auto w = static_cast<std::uint32_t>(width), h = static_cast<std::uint32_t>(height);
    directory.add(254, kLong, {0});
    directory.add(256, kLong, {w});
    directory.add(257, kLong, {h});
    directory.add(258, kShort, {16});
    directory.add(259, kShort, {1});
    directory.add(262, kShort, {32803});
    directory.add(273, kLong, {static_cast<std::uint32_t>(samples_at)});
    directory.add(277, kShort, {1});
    directory.add(278, kLong, {h});
    directory.add(279, kLong, {w * h * 2});
    directory.add(33421, kShort, {2, 2});
    directory.add(
        33422, kByte,
        {settings.filters[0], settings.filters[1], settings.filters[2], settings.filters[3]});
    directory.add(50714, kLong, {settings.black});
    directory.add(50717, kLong, {settings.white});
}

}  // namespace

std::vector<std::uint16_t> sensor_samples(const Image& picture, const DngSettings& settings) {
    std::vector<std::uint16_t> samples;
    const float range = static_cast<float>(settings.white - settings.black);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto filter = static_cast<std::size_t>(y % 2 * 2 + x % 2);
            const float value = std::clamp(picture.at(x, y)[settings.filters[filter]], 0.0f, 1.0f);
            samples.push_back(
                static_cast<std::uint16_t>(settings.black + std::lround(value * range)));
        }
    return samples;
}

std::vector<std::byte> dng_of(int width, int height, const std::vector<std::uint16_t>& samples,
                              const DngSettings& settings) {
    constexpr std::size_t kHeader = 8, kPreviewBytes = kPreviewWidth * kPreviewHeight * 3;
    // Directories first; their sizes do not depend on the offsets in them.
    const auto directories = [&](std::size_t sensor_at, std::size_t data_at) {
        TiffDirectory first, sensor;
        add_camera(first, settings);
        if (settings.has_preview) {
            first.add(330, kLong, {static_cast<std::uint32_t>(sensor_at)});
            add_preview(first, data_at);
            add_sensor(sensor, width, height, data_at + kPreviewBytes, settings);
        } else {
            add_sensor(first, width, height, data_at, settings);
        }
        return std::pair(first, sensor);
    };
    const auto [draft, draft_sensor] = directories(0, 0);
    const std::size_t sensor_at = kHeader + draft.size();
    const std::size_t data_at = sensor_at + (settings.has_preview ? draft_sensor.size() : 0);
    auto [first, sensor] = directories(sensor_at, data_at);

    Bytes file;
    put(file, 0x002A4949, 4);  // "II*\0"
    put(file, kHeader, 4);
    first.write(file);
    if (settings.has_preview) {
        sensor.write(file);
        // Of a brightness that the sensor data do not have.
        file.insert(file.end(), kPreviewBytes, std::byte{200});
    }
    for (const std::uint16_t sample : samples) put(file, sample, 2);
    return file;
}

std::vector<std::byte> dng_of(const Image& picture, const DngSettings& settings) {
    return dng_of(picture.width, picture.height, sensor_samples(picture, settings), settings);
}

}  // namespace burnish::test
