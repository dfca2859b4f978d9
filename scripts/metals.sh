#!/bin/sh
# Makes the tables and the picture of docs/evidence/metals.md again. Usage: metals.sh BUILD_FOLDER
# Needs the targets burnish_cli and tabulate_metals (benchmarks on), oiiotool and cjpeg.
set -eu
cd "$(dirname "$0")/.."
bin=$1/bin
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sphere() { # metal nm stops
    "$bin/burnish" render builtin:sphere --metal "$1" --oxide "$2" --alpha-x 0.12 --alpha-y 0.3 \
        --tone-map linear --exposure "$3" --background-color '#202020' --background color --samples 64 --size 150x150 \
        -o "$folder/sphere_$1_$2.png" >/dev/null
}
for metal in gold silver copper aluminium steel brass titanium iron chromium nickel tungsten bronze; do
    sphere $metal 0 -0.8
done
for nm in 20 35 50 75 110 145; do sphere titanium $nm 0.4; done
for nm in 20 32 40 48 64 110; do sphere iron $nm 0.4; done
"$bin/tabulate_metals" docs/evidence/metals.md
"$bin/tabulate_metals" --sheet "$folder"
oiiotool "$folder/metals.png" -o "$folder/metals.ppm"
# cjpeg writes no metadata, which a test asks for.
cjpeg -quality 78 "$folder/metals.ppm" >docs/images/metals.jpg
