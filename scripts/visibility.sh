#!/bin/sh
# Errors of pictures with and without visibility against brute force, as the table of docs/theory/visibility.md. Usage:
#   visibility.sh BIN FOLDER SCENE [PATHS]
# BIN: the folder of burnish, trace_stage and picture_error. SCENE: of materials without textures. PATHS: a pixel, 3000.
set -eu
bin=$1
out=$2
scene=$3
paths=${4:-3000}
mkdir -p "$out"
small() { "$bin/burnish" render "$scene" --size 300x200 "$@" >/dev/null; }
small -o "$out/without.exr" --visibility=false
small -o "$out/no-bounce.exr" --bounces 0
small -o "$out/one-bounce.exr" --bounces 1
small -o "$out/two-bounces.exr"
small -o "$out/prefiltered.exr" --image-light prefiltered
sed 's/"width": [0-9]*, "height": [0-9]*/"width": 300, "height": 200/' "$scene" >"$out/small.json"
"$bin/trace_stage" "$out/small.json" "$paths" 8 "$out/truth.exr"
cd "$out"
"$bin/picture_error" truth.exr without.exr no-bounce.exr one-bounce.exr two-bounces.exr prefiltered.exr
