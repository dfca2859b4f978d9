// The numbers of an OBJ file's lines, held against what the parser would make of them in silence.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// The number that a word states as a whole, 0 for one too small for a double; nothing for other
// words and for numbers that are not finite.
std::optional<double> finite_number(std::string_view word);

// Removes the next word from the front of `rest` and returns it; empty at the end.
std::string_view take_word(std::string_view& rest);

// Checks the lines v, vt, vn and f, and appends them to the text for the parser. Positions must be
// numbers within kFarthest, as those of glTF must; coordinates and normals that are none are read as
// 0, with a warning, as those of glTF are.
class ObjNumbers {
  public:
    ObjNumbers(std::string& geometry, const std::string& file) : geometry_(geometry), file_(file) {}

    // `word` is v, vt, vn or f, `rest` what follows it in line `number` of the file. Throws Error
    // naming file and line for positions that are no numbers, and for faces of more than 255
    // corners, or with corners that are no numbers of vertices.
    void take(std::string_view word, std::string_view rest, std::size_t number);

    // To be called after the last line: throws Error for a vertex that the file does not have, and
    // appends the warnings.
    void finish(std::vector<std::string>& warnings) const;

  private:
    enum Kind { vertex, texcoord, normal };
    static constexpr std::size_t kKinds = 3;
    using Corner = std::array<std::int64_t, kKinds>;

    // Lines of one kind that say the same: the first one in words, and the number of all.
    struct Odd {
        std::string first;
        std::size_t lines = 0;
        void add(const std::string& text) {
            if (lines++ == 0) first = text;
        }
    };
    struct Largest {
        std::int64_t index = 0;
        std::size_t line = 0;
    };

    void take_position(std::string_view rest, std::size_t number);
    void take_floats(Kind kind, std::string_view rest, std::size_t number);
    void take_face(std::string_view rest, std::size_t number);
    void take_corner(std::string_view word, std::size_t number);
    [[noreturn]] void fail(std::size_t number, std::string_view key, std::string_view expected,
                           std::string_view found) const;

    std::string& geometry_;
    const std::string& file_;
    std::array<std::int64_t, kKinds> counts_ = {};
    std::array<Largest, kKinds> largest_;  // of the indices counted from the start
    std::array<Odd, kKinds> odd_values_, odd_indices_;
    Odd small_faces_;
};

}  // namespace burnish
