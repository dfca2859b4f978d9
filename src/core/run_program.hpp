// Other programs, run to their end.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace burnish {

struct ProgramResult {
    int exit_code = 0;     // 128 and the signal's number for a program that a signal has ended
    std::string messages;  // standard error, the first 64 KB of it
};

// Runs words[0], which is searched in PATH, with the other words as its arguments and an empty standard
// input; no shell reads them. `on_output` receives the standard output piece by piece, and "" where
// nothing came for 0.1 s. Where it throws, the program is ended and the exception goes on. None: there
// is no such program. Throws Error for one that cannot be started.
std::optional<ProgramResult> run_program(
    std::span<const std::string> words,
    const std::function<void(std::string_view)>& on_output = {});

}  // namespace burnish
