#!/bin/sh
# Errors of pictures with and without visibility against brute force, as a row of the table of
# docs/theory/visibility.md, and a sheet: without visibility, with it, brute force. Usage:
#   visibility.sh BIN FOLDER SCENE [PATHS [EXPOSURE]]
# BIN: the folder of burnish and picture_error. PATHS: a pixel, 1024. EXPOSURE: a factor on what the sheet shows, 1.5.
# Needs oiiotool and cjpeg.
# FOLDER keeps the pictures; a brute force that lies there is kept: it takes minutes.
set -eu
bin=$1
out=$2
scene=$3
paths=${4:-1024}
factor=${5:-1.5}
size=360x240
name=$(basename "$scene" .json)
mkdir -p "$out"
out=$out/$name
small() { "$bin/burnish" render "$scene" --size $size "$@" >/dev/null; }
small -o "$out-without.exr" --visibility=false
small -o "$out-no-bounce.exr" --bounces 0
small -o "$out-one-bounce.exr" --bounces 1
small -o "$out-two-bounces.exr"
small -o "$out-prefiltered.exr" --image-light prefiltered
traced() { "$bin/burnish" trace "$scene" --size $size "$@" >/dev/null; }
[ -f "$out-truth.exr" ] || traced --samples "$paths" -o "$out-truth.exr"
# A quarter of the paths, at other random numbers: the noise of all of them is 1/sqrt(5) of the difference.
[ -f "$out-quarter.exr" ] || traced --samples $((paths / 4)) --seed 2 -o "$out-quarter.exr"

# The mean of the three channels of a picture that oiiotool makes, radiance counting up to 4.
mean() { oiiotool "$@" --clamp:max=4 --printstats | awk '/Stats Avg/ { print ($3 + $4 + $5) / 3 }'; }

truth=$(mean "$out-truth.exr")
echo "| picture | rms of radiance | rms as displayed | relative | mean |"
echo "|---|---|---|---|---|"
for picture in without no-bounce one-bounce two-bounces prefiltered quarter; do
    # shellcheck disable=SC2046  # three words
    set -- $("$bin/picture_error" "$out-truth.exr" "$out-$picture.exr")
    difference=$(mean "$out-$picture.exr" --ch R,G,B "$out-truth.exr" --absdiff)
    bias=$(mean "$out-$picture.exr" --ch R,G,B)
    awk -v name="$picture" -v rms="$2" -v shown="$3" -v difference="$difference" -v mean="$bias" \
        -v truth="$truth" 'BEGIN {
        scale = 1
        if (name == "quarter") { name = "noise of the paths"; scale = 1 / sqrt(5) }
        printf "| %s | %.3f | %.3f | %.1f %% | %+.1f %% |\n", name, rms * scale, shown * scale,
            100 * scale * difference / truth, 100 * (mean / truth - 1)
    }'
done

set --
for picture in without two-bounces truth; do
    oiiotool "$out-$picture.exr" --ch R,G,B --mulc "$factor" --colorconvert linear srgb -o "$out-$picture.ppm"
    set -- "$@" "$out-$picture.ppm"
done
oiiotool "$@" --mosaic 3x1 -o "$out-sheet.ppm"
# cjpeg writes no metadata, which a test asks for.
cjpeg -quality 88 "$out-sheet.ppm" >"$out.jpg"
