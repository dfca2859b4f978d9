// Words for people: plurals, the order of names, and names that a person has mistyped.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

// The count with its noun: "1 mesh", "2 meshes".
std::string plural(std::size_t count, std::string_view word);

// The word in single quotes if a POSIX shell would interpret any of its characters.
std::string shell_quoted(std::string_view word);
// Appends the line unless it is there.
void append_once(std::vector<std::string>& lines, std::string line);

// Index of `name` in `names`. Throws UsageError "<where>: unknown <kind> 'x'; did you mean 'y'? known: ..."
// when it is not there.
int index_of_name(std::span<const std::string_view> names, std::string_view name,
                  std::string_view kind, std::string_view where);

// The order in which people number files: digits within names are compared as numbers ("p2" before
// "p10"), letters without case (of ASCII). Names that are alike so far are ordered by bytes.
bool natural_less(std::string_view a, std::string_view b);

// The known name nearest to `name` by edit distance; empty when none is near.
std::string_view nearest_name(std::span<const std::string_view> names, std::string_view name);

}  // namespace burnish
