#!/bin/sh
# Errors of pictures of few samples against pictures of 4096, and their processor time, as the table of
# docs/evidence/noise.md. Usage:
#   noise.sh BURNISH PICTURE_ERROR FOLDER ENVIRONMENTS [OLD_BURNISH]
# PICTURE_ERROR: the program of bench/picture_error.cpp. ENVIRONMENTS: a folder with
# venice_sunset_1k.hdr and royal_esplanade_1k.hdr of Poly Haven. OLD_BURNISH: another version to compare
# with, which also draws the references. References that lie in FOLDER are kept: they take minutes.
set -eu
burnish=$1
error_of=$2
out=$3
environments=$4
old=${5:-}
mkdir -p "$out"

# Bars of 8 mm in a fan, 1 m long: less than two pixels wide in the picture.
bars() {
    awk 'BEGIN {
        for (i = 0; i < 28; ++i) {
            angle = 0.02 + i * 3.14159265 / 28; c = cos(angle); s = sin(angle)
            for (side = 0; side < 4; ++side) {
                for (end = -0.5; end <= 0.5; ++end) for (edge = 0; edge < 2; ++edge) {
                    turn = (side + edge) * 1.570796327 + 0.785398163
                    across = 0.004 * cos(turn)
                    printf "v %.6f %.6f %.6f\n", end * c - across * s, end * s + across * c,
                        0.004 * sin(turn) + 0.006 * i
                }
                printf "f %d %d %d %d\n", n + 1, n + 2, n + 4, n + 3; n += 4
            }
        }
    }' >"$out/bars.obj"
}

# Sets $arguments to those of a scene.
choose() {
    sunset=$environments/venice_sunset_1k.hdr
    room=$environments/royal_esplanade_1k.hdr
    case $1 in
        brushed) arguments="builtin:sphere --metal steel --alpha-x 0.08 --alpha-y 0.4
                            --camera-zoom 1.1 --env $sunset" ;;
        bumps) arguments="builtin:torus --metal gold --roughness 0.55 --anisotropy 0.6
                          --normal-map builtin:bumps --uv-scale 2 --env $sunset" ;;
        bars) arguments="$out/bars.obj --metal aluminium --alpha-x 0.15 --alpha-y 0.3
                         --double-sided --env $sunset" ;;
        polished) arguments="builtin:torus --metal gold --roughness 0.2 --anisotropy 0.7
                             --env $room" ;;
        plastic) arguments="builtin:sphere --metallic 0 --roughness 0.8 --anisotropy 0.5
                            --env $room" ;;
    esac
}

# Renders a scene: PROGRAM SCENE SAMPLES FILE [FLAG...]. Prints the processor seconds.
draw() {
    program=$1 scene=$2 samples=$3 file=$4
    shift 4
    choose "$scene"
    # shellcheck disable=SC2086  # the arguments are meant to be split
    ("$program" render $arguments --size 320x180 --samples "$samples" "$@" -o "$file" >/dev/null
        times) | awk 'NR == 2 { split($1, u, /[ms]/); split($2, s, /[ms]/)
                                printf "%.2f", 60 * u[1] + u[2] + 60 * s[1] + s[2] }'
}

bars
echo "| scene | samples | program | linear | displayed | processor s |"
echo "|---|---|---|---|---|---|"
for scene in brushed bumps bars polished plastic; do
    reference=$out/$scene.exr
    [ -f "$reference" ] || draw "${old:-$burnish}" "$scene" 4096 "$reference" --seed 777 >/dev/null
    for samples in 1 8 64; do
        for program in ${old:+"$old"} "$burnish"; do
            file=$out/latest.exr
            seconds=$(draw "$program" "$scene" "$samples" "$file")
            # shellcheck disable=SC2046  # three words
            set -- $("$error_of" "$reference" "$file")
            echo "| $scene | $samples | $program | $2 | $3 | $seconds |"
        done
    done
done
