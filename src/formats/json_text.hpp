// Reads JSON written by a person: errors name the position, and duplicate keys are rejected.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// Parses a JSON document. Throws Error "<file>: line 3, column 7: expected ..., found ..." for
// invalid JSON, for a key given twice in one object and for nesting deeper than 32.
nlohmann::json parse_json(const std::string& file, std::string_view text);

// A value and its path, such as "objects[2].translate", for messages. Does not own the value.
class JsonPlace {
  public:
    JsonPlace(const std::string& file, const nlohmann::json& value)
        : file_(&file), value_(&value) {}

    const nlohmann::json& value() const { return *value_; }
    const std::string& path() const { return path_; }
    const std::string& file() const { return *file_; }
    bool is_text() const;

    // Throws Error "<file>: <path>: expected <expected>, found <the value>".
    [[noreturn]] void fail(std::string_view expected) const;

    // Throws unless the value is an object with only these keys; suggests the nearest one.
    void require_object(std::span<const std::string_view> keys) const;
    void require_object() const;  // any keys
    void require_array(std::size_t most) const;

    bool has(std::string_view key) const;
    JsonPlace at(std::string_view key) const;  // throws when the object has no such key
    JsonPlace at(std::size_t index) const;     // of an array, index in range
    std::size_t size() const;

    std::string text() const;
    double number(double low, double high) const;
    glm::vec3 triple(double low, double high) const;  // [x, y, z]
    std::array<double, 3> double_triple(double low, double high) const;

    std::vector<std::string> keys() const;  // of an object

  private:
    JsonPlace(const JsonPlace& parent, const nlohmann::json& value, std::string path)
        : file_(parent.file_), value_(&value), path_(std::move(path)) {}

    const std::string* file_;
    const nlohmann::json* value_;
    std::string path_;
};

}  // namespace burnish
