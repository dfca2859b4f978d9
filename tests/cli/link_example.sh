#!/bin/sh
# Installs the build into a folder of its own, compiles every public header alone, builds the programs of
# examples/link against the installed library and runs them.
# Usage: link_example.sh SOURCE BUILD
set -eu
source=$1
build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$build" --prefix "$folder/installed" >"$folder/log" || { cat "$folder/log"; exit 1; }

include=$(dirname "$(dirname "$(find "$folder/installed" -name error.hpp)")")
for header in $(cd "$include" && find burnish -name '*.hpp'); do
    printf '#include <%s>\nint main() {}\n' "$header" |
        ${CXX:-c++} -std=c++20 -fsyntax-only -I"$include" -x c++ - || { echo "$header does not compile alone"; exit 1; }
done

cmake -S "$source/examples/link" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed"
cmake --build "$folder/build"
"$folder/build/evaluate"
"$folder/build/render_in_memory" "$folder/picture.png"
test -s "$folder/picture.png"
"$folder/build/fit_in_memory"
"$folder/installed/bin/burnish" --version
