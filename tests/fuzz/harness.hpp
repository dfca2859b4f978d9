// What the fuzz targets share: a folder in memory for readers that take paths, and the promise that
// every reader makes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace burnish::fuzz {

using Bytes = std::span<const std::uint8_t>;

// The folder of this process, in memory where the system has such a place. Whatever an input may
// refer to lies in it: a picture `map.png`, an environment `sky.exr`, models `part.obj` and
// `part.gltf`.
const std::filesystem::path& folder();

std::filesystem::path put(std::string_view name, Bytes bytes);

// Runs a reader. It may succeed or throw burnish::Error with one line of text; anything else, what
// the sanitizers see included, ends the process.
void expect_answer(const std::function<void()>& read);

// Ends the process with the words, so that the fuzzer keeps the input.
[[noreturn]] void broken(std::string_view what);

}  // namespace burnish::fuzz
