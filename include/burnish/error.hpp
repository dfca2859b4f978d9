// Errors: what every layer throws and what the command line prints as one line.
//
// Threads: errors are values; any number of threads may call the functions.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// Something that was asked for cannot be done: a file is broken, a value is out of range, a device
// is missing. `what()` is one line whatever went in: control characters become spaces. The command
// line prints it and exits 1.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& line);

    // "<where>: <key>: expected <expected>, found <found>". `where` is the file (or flag) at fault,
    // `key` the place inside it; any part may be empty and is then left out with its word.
    Error(std::string_view where, std::string_view key, std::string_view expected,
          std::string_view found);
};

// The command itself is wrong (unknown flag, name or value). The command line exits 2.
class UsageError : public Error {
  public:
    using Error::Error;
};

// Ctrl-C: long work stops at its next step. The command line exits 130.
class Interrupted : public Error {
  public:
    Interrupted() : Error("interrupted") {}
};

// A value found in a file or a flag, made fit for an error line: quoted, control characters
// replaced, cut at 60 bytes (never inside a UTF-8 character).
std::string shown(std::string_view text);

// Text of somebody else (a library's error, a label) on one line: control characters and runs of
// spaces become one space, the ends are trimmed.
std::string one_line(std::string_view text);

}  // namespace burnish
