#!/bin/sh
# Installs the build into a folder of its own, builds examples/link against it and runs what comes out.
# Usage: link_example.sh SOURCE BUILD
set -eu
source=$1
build=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cmake --install "$build" --prefix "$folder/installed" >"$folder/log" || { cat "$folder/log"; exit 1; }
cmake -S "$source/examples/link" -B "$folder/build" -DCMAKE_PREFIX_PATH="$folder/installed"
cmake --build "$folder/build"
"$folder/build/bent_lobe" "$folder/picture.png"
test -s "$folder/picture.png"
"$folder/installed/bin/burnish" --version
