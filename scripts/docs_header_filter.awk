# Marks the comments of our headers for doxygen, which reads /// and ///< only:
#   a // block before a declaration becomes ///, a // after one on its line ///<.
# The block at the top of a file is about the file.
function is_declaration(text) { return text ~ /^ *[A-Za-z_}~\[]/ && text !~ /^ *namespace|^ *}/ }
# Signs that doxygen would read as commands and tags stand for themselves.
function documentation(text) {
    gsub(/[\\@<>]/, "\\\\&", text)
    while (match(text, /`[^`]*`/))
        text = substr(text, 1, RSTART - 1) "<tt>" substr(text, RSTART + 1, RLENGTH - 2) "</tt>" substr(text, RSTART + RLENGTH)
    return text
}
/^#include "shading\// { $0 = "" }  # the maths has pages of its own
{
    line = $0
    if (match(line, /^ *\/\/ ?/)) {
        pending[++count] = line
        next
    }
    if (count > 0) {
        top = !seen_code && !told_file
        doc = top || is_declaration(line)
        if (top) { print "/// @file"; told_file = 1 }
        for (i = 1; i <= count; ++i) {
            text = pending[i]
            if (doc && text !~ /clang-format|NOLINT/) { text = documentation(text); sub(/\/\//, "///", text) }
            print text
        }
        count = 0
    }
    if (line ~ /[^ ]/) seen_code = 1
    # A comment behind a member or an enumerator; not one behind an #include or a closing brace.
    if (line ~ /[;,{a-z0-9] +\/\/ / && line !~ /^ *#|^ *}|NOLINT|clang-format/) {
        at = index(line, " // ")
        line = substr(line, 1, at) "///< " documentation(substr(line, at + 4))
    }
    print line
}
END { for (i = 1; i <= count; ++i) print pending[i] }
