#include <fmt/format.h>

#include "image/guard/container_checks.hpp"

namespace burnish {
namespace {

constexpr int kMaxBoxes = 4096;

struct HeifBox {
    std::string_view type;
    std::uint64_t data = 0, end = 0;
};

// The box at `at` of a parent that ends at `end`. A length of 1 says that 64 bits follow, one of 0
// that the box goes on to the end.
HeifBox heif_box_at(const ByteCursor& file, std::uint64_t at, std::uint64_t end) {
    std::uint64_t length = file.u32(at, kBigEndian), header = 8;
    const std::string_view type = file.text(at + 4, 4);
    if (length == 1) {
        length = std::uint64_t{file.u32(at + 8, kBigEndian)} << 32 | file.u32(at + 12, kBigEndian);
        header = 16;
    }
    if (length == 0) length = end - at;
    if (length < header) file.fail(fmt::format("a box {} of {} bytes", shown(type), length));
    if (length > end - at) {
        if (end == file.size()) file.truncated();
        file.fail(fmt::format("a box {} longer than the one around it", shown(type)));
    }
    return {type, at + header, at + length};
}

class HeifWalk {
  public:
    explicit HeifWalk(const ByteCursor& file) : file_(file) {}

    void run() {
        boxes(0, file_.size());
        if (!sized_) file_.fail("no picture in it");
    }

  private:
    void boxes(std::uint64_t at, std::uint64_t end) {
        while (at < end) {
            if (++count_ > kMaxBoxes) file_.fail("too many boxes");
            const HeifBox box = heif_box_at(file_, at, end);
            constexpr std::uint64_t kVersionBytes = 4;
            if (box.type == "meta") boxes(box.data + kVersionBytes, box.end);
            if (box.type == "iprp" || box.type == "ipco") boxes(box.data, box.end);
            if (box.type == "ispe") size_of(box);
            at = box.end;
        }
    }

    // Size of one picture: a whole one, a tile of it, or a thumbnail.
    void size_of(const HeifBox& box) {
        const std::uint64_t width = file_.u32(box.data + 4, kBigEndian);
        const std::uint64_t height = file_.u32(box.data + 8, kBigEndian);
        check_image_size(static_cast<std::int64_t>(width), static_cast<std::int64_t>(height),
                         file_.name());
        check_decoded_bytes(width * height * 4, file_.size(), file_.name());
        sized_ = true;
    }

    const ByteCursor& file_;
    int count_ = 0;
    bool sized_ = false;
};

}  // namespace

void check_boxes(const ByteCursor& file) {
    for (std::uint64_t at = 0; at < file.size();) at = heif_box_at(file, at, file.size()).end;
}

void check_heif(const ByteCursor& file) {
    HeifWalk(file).run();
}

}  // namespace burnish
