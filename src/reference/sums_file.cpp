#include "reference/sums_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <span>
#include <string_view>

#include "burnish/error.hpp"
#include "core/files.hpp"

namespace burnish {
namespace {

static_assert(std::endian::native == std::endian::little, "files of sums hold words as they are");

constexpr std::string_view kFirstLine = "burnish trace sums 1";
constexpr int kMostSide = 16384;  // of a picture

// FNV-1a over words of 64 bits.
class Checksum {
  public:
    void add(std::span<const std::byte> bytes) {
        for (std::size_t i = 0; i < bytes.size(); i += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
            value_ = (value_ ^ word) * 0x100000001b3ULL;
        }
    }
    std::uint64_t value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

// A line cannot hold line breaks.
std::string in_one_line(std::string text) {
    for (char& c : text)
        if (c == '\n' || c == '\r') c = ' ';
    return text;
}

std::string header_of(const SumsFile& file) {
    std::string text =
        fmt::format("{}\nprint={:016x}\nwidth={}\nheight={}\nlayers={}\nshard={}\nshards={}\n",
                    kFirstLine, file.print, file.sums.width(), file.sums.height(),
                    file.sums.has_layers() ? 1 : 0, file.shard.index, file.shard.count);
    for (const auto& [name, value] : file.words)
        text += fmt::format("word.{}={}\n", name, in_one_line(value));
    return text + "\n";
}

class Reader {
  public:
    explicit Reader(const std::filesystem::path& path)
        : path_(path), bytes_(read_file(path, std::uintmax_t{1} << 40)) {}

    [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
        throw Error(path_.string(), "", expected, found);
    }

    std::string line() {
        std::string text;
        while (at_ < bytes_.size()) {
            const char c = std::to_integer<char>(bytes_[at_++]);
            if (c == '\n') return text;
            text += c;
        }
        refuse("a whole file of sums of `burnish trace`", "its end");
    }

    template <typename T>
    void words(std::vector<T>& to) {
        const std::size_t size = to.size() * sizeof(T);
        if (bytes_.size() - at_ < size) refuse("a whole file of sums", "its end");
        if (size > 0) std::memcpy(to.data(), bytes_.data() + at_, size);
        at_ += size;
    }

    void check_end() {
        Checksum sum;
        sum.add(std::span(bytes_).first(at_));
        std::vector<std::uint64_t> stored(1);
        words(stored);
        if (stored[0] != sum.value() || at_ != bytes_.size())
            refuse("a sound file of sums", "a damaged one");
    }

  private:
    std::filesystem::path path_;
    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
};

std::map<std::string, std::string> header_lines(Reader& reader) {
    if (reader.line() != kFirstLine)
        reader.refuse("sums of `burnish trace`", "another kind of file");
    std::map<std::string, std::string> lines;
    for (std::string line = reader.line(); !line.empty(); line = reader.line()) {
        const std::size_t equals = line.find('=');
        if (equals != line.npos) lines[line.substr(0, equals)] = line.substr(equals + 1);
    }
    return lines;
}

std::uint64_t number(const Reader& reader, const std::map<std::string, std::string>& lines,
                     const std::string& key, std::uint64_t most, int base = 10) {
    const auto found = lines.find(key);
    std::uint64_t value = 0;
    const std::string text = found == lines.end() ? "" : found->second;
    const auto end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value, base);
    if (text.empty() || parsed.ec != std::errc{} || parsed.ptr != end || value > most)
        reader.refuse(fmt::format("{} from 0 to {}", key, most), text.empty() ? "none" : text);
    return value;
}

}  // namespace

void write_sums(const std::filesystem::path& path, const SumsFile& file) {
    std::vector<std::byte> whole;
    const auto append = [&](const void* data, std::size_t size) {
        const auto* bytes = static_cast<const std::byte*>(data);
        whole.insert(whole.end(), bytes, bytes + size);
    };
    const std::string header = header_of(file);
    whole.reserve(header.size() + file.sums.counts().size() * sizeof(std::uint32_t) +
                  file.sums.colors().size() * sizeof(ColorSums) +
                  file.sums.layers().size() * sizeof(LayerSums) + sizeof(std::uint64_t));
    append(header.data(), header.size());
    append(file.sums.counts().data(), file.sums.counts().size() * sizeof(std::uint32_t));
    append(file.sums.colors().data(), file.sums.colors().size() * sizeof(ColorSums));
    append(file.sums.layers().data(), file.sums.layers().size() * sizeof(LayerSums));
    // Over the bytes as they lie in the file, in words from its start.
    Checksum sum;
    sum.add(whole);
    const std::uint64_t value = sum.value();
    append(&value, sizeof value);
    write_bytes(path, whole);
}

SumsFile read_sums(const std::filesystem::path& path) {
    Reader reader(path);
    const auto lines = header_lines(reader);
    const auto side = [&](const char* key) {
        const auto value = static_cast<int>(number(reader, lines, key, kMostSide));
        if (value < 1) reader.refuse(std::string(key) + " of at least 1", "0");
        return value;
    };
    const int width = side("width"), height = side("height");
    SumsFile file{number(reader, lines, "print", ~std::uint64_t{0}, 16),
                  {},
                  {},
                  TraceSums(width, height, number(reader, lines, "layers", 1) == 1)};
    file.shard.index = static_cast<int>(number(reader, lines, "shard", 1 << 20));
    file.shard.count = static_cast<int>(number(reader, lines, "shards", 1 << 20));
    for (const auto& [key, value] : lines)
        if (key.starts_with("word.")) file.words[key.substr(5)] = value;
    reader.words(file.sums.counts());
    reader.words(file.sums.colors());
    reader.words(file.sums.layers());
    reader.check_end();
    return file;
}

}  // namespace burnish
