#!/bin/sh
# Measures the window of `burnish view` by scripts, on a virtual display of 1280x720: frame rates while
# the camera is moved, the first picture, changes, rest and memory. Usage: view_frames.sh [OUTPUT.md]
# Expects a release build in build/release. The sample data of BURNISH_DATA joins in where it is there.
set -eu
cd "$(dirname "$0")/.."
output=${1:-bench/results/$(date +%F)-view.md}
program=$PWD/build/release/bin/burnish-view
data=${BURNISH_DATA:-../shared/data}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# run NAME SCRIPT [FILE...]: the values that the script logs go to $work/NAME.
run() {
    name=$1
    printf '%s\n' "$2" >"$work/script.txt"
    shift 2
    xvfb-run -a -s "-screen 0 1280x720x24" "$program" --size 1280x720 --ui-scale 1 --state none \
        --script "$work/script.txt" "$@" >"$work/$name" || {
        echo "view_frames: $name failed" >&2
        exit 1
    }
}
# value NAME WHAT [NUMBER]: what was logged, for the NUMBERth time (default: the first).
value() {
    awk -v what="$2" -v wanted="${3:-1}" '$1 == what && ++n == wanted { print $2 }' "$work/$1"
}

# row LABEL SETUP [FILE...]: one line of the table of frame rates.
motion="wait 2
drag orbit 600 100 ${DRAG_FRAMES:-120}
log fps fps_min scene_triangles scale first_picture_s whole_picture_s frame_cpu_ms
quit"
row() {
    label=$1
    setup=$2
    shift 2
    run row "$setup
wait 5
$motion" "$@"
    printf '| %s | %.0f | %.1f | %.1f | %.0f | %.2f | %.2f | %.2f |\n' "$label" "$(value row scene_triangles)" \
        "$(value row fps)" "$(value row fps_min)" "$(value row frame_cpu_ms)" "$(value row scale)" "$(value row first_picture_s)" "$(value row whole_picture_s)"
}

frames() {
    echo "| scene | triangles | frames/s | slowest frame, as frames/s | processor time of a frame, all threads, ms | scale of the resolution at the end | first picture, s | with all materials, s |"
    echo "|---|---|---|---|---|---|---|---|"
    row "first scene" ""
    row "torus, steel, bumps, one light, prefiltered environment" "set triangles 102400
set metal steel
set normal_map builtin:bumps
light 30,45,2
set image_light prefiltered" builtin:torus
    sky=$(find "$data/environments" -name '*.hdr' 2>/dev/null | sort | head -n 1)
    [ -n "$sky" ] || return 0
    find "$data/models" -name '*.glb' -o -name 'Suzanne.gltf' | sort | while read -r model; do
        row "$(basename "$model"), $(basename "$sky" .hdr)" "" "$model" "$sky" </dev/null
    done
}

changes() {
    # At rest the window compiles what the next change needs.
    run change 'set samples 16
set method normal-map
wait rest
wait seconds 15
set method follow-grain
wait 1
log change_s
set method normal-map
wait 1
log change_s
set mdf beckmann
wait 1
log change_s
set mdf ggx
wait 1
set mdf beckmann
wait 1
log change_s
set brdf ward
wait 1
log change_s
set brdf microfacet
wait 1
set brdf ward
wait 1
log change_s' builtin:torus
    echo "| change | seconds until it is shown, always in the next frame |"
    echo "|---|---|"
    n=0
    for label in "method, first time" "method, again" "mdf, first time" "mdf, again" \
        "brdf, first time" "brdf, again"; do
        n=$((n + 1))
        printf '| %s | %.3f |\n' "$label" "$(value change change_s $n)"
    done
}

rest() {
    run idle 'set samples 4
wait rest
wait seconds 30
wait seconds 10
log idle_cpu' builtin:torus
    {
        echo 'set samples 1'
        echo 'wait rest'
        echo 'log memory_mb'
        for pass in 1 2 3; do
            i=0
            while [ $i -lt 200 ]; do
                i=$((i + 1))
                echo "set alpha_x 0.$((100 + i + pass))"
            done
            printf 'wait rest\nundo 200\nwait rest\nlog memory_mb\n'
        done
    } >"$work/edits.txt"
    run memory "$(cat "$work/edits.txt")" builtin:torus
    echo "| at rest | |"
    echo "|---|---|"
    printf '| processor time over 10 s, %% of a core | %.2f |\n' "$(value idle idle_cpu)"
    printf '| resident memory before, after 200, 400, 600 edits and undos, MB | %.0f, %.0f, %.0f, %.0f |\n' \
        "$(value memory memory_mb 1)" "$(value memory memory_mb 2)" "$(value memory memory_mb 3)" \
        "$(value memory memory_mb 4)"
}

{
    echo "# The window of \`burnish view\`"
    echo
    echo "$(date +%F), $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) threads."
    echo "A window of 1280x720 on a virtual display (Xvfb), by scripts/view_frames.sh. Frames are timed from"
    echo "one to the next, with the interface and the copy onto the display."
    echo
    frames
    echo
    changes
    echo
    rest
} >"$work/table.md"
cp "$work/table.md" "$output"
cat "$output"
