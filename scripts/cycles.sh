#!/bin/sh
# Brushed spheres by Burnish beside Blender's Cycles: the table and the sheet of docs/evidence/cycles.md. Usage:
#   cycles.sh BURNISH FOLDER ENVIRONMENT.hdr [SAMPLES]
# SAMPLES: of Cycles, 256 a pixel. Needs blender (3.x), oiiotool and cjpeg. Pictures that lie in FOLDER are kept.
set -eu
if ! command -v blender >/dev/null; then
    echo "cycles: blender is not installed; nothing was compared (Debian's package: blender)"
    exit 0
fi
burnish=$1
out=$2
environment=$(realpath "$3")
samples=${4:-256}
here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
mkdir -p "$out"
view="azimuth=35 elevation=15 distance=2.2 fov=30 size=240"

# by_cycles NAME KEY=VALUE...
by_cycles() {
    name=$1
    shift
    [ -f "$out/$name.cycles.exr" ] && return
    # shellcheck disable=SC2086  # a list of words
    blender -b --factory-startup --python-exit-code 1 --python "$here/cycles_sphere.py" -- \
        "$out/$name.cycles.exr" $view samples="$samples" "$@" >"$out/$name.log" 2>&1 ||
        { echo "cycles: blender failed: $out/$name.log" >&2; exit 1; }
}

# by_burnish NAME ENVIRONMENT RADIANCE_OF_STRIP MATERIAL FLAG...: the same sphere from a scene file.
by_burnish() {
    name=$1 lit=$2 strip=$3 material=$4
    shift 4
    [ -f "$out/$name.burnish.exr" ] && return
    lights=
    [ "$strip" = 0 ] || lights=$(printf '"lights": [{"type": "rectangle", "position": [-1.2, 0.5, 1.4],
        "direction": [1.2, -0.5, -1.4], "size": [0.3, 1.8], "radiance": %s, "visible": false}],' "$strip")
    cat >"$out/$name.json" <<END
{
  "format": "burnish-scene", "version": 1,
  "objects": [{"model": "builtin:sphere", "material": "metal"}],
  "materials": {"metal": {$material}},
  $lights
  "environment": "$lit",
  "parameters": {"width": 240, "height": 240, "camera_azimuth": 35, "camera_elevation": 15, "camera_fov": 30,
                 "camera_distance": 2.2, "camera_target": [0, 0, 0], "background": "transparent"}
}
END
    "$burnish" render "$out/$name.json" --samples 256 "$@" -o "$out/$name.burnish.exr" >/dev/null
}

# The mean of the channels of what oiiotool makes.
mean() { oiiotool "$@" --printstats | awk '/Stats Avg/ { print ($3 + $4 + $5) / 3 }'; }

# figures NAME TEXT: a row of the table. Pictures are black around the sphere, which covers a share of them.
figures() {
    a=$out/$1.burnish.exr
    b=$out/$1.cycles.exr
    share=$(oiiotool "$b" --ch A,A,A --printstats | awk '/Stats Avg/ { print $3 }')
    square=$(mean "$a" --ch R,G,B "$b" --ch R,G,B --sub --dup --mul)
    absolute=$(mean "$a" --ch R,G,B "$b" --ch R,G,B --absdiff)
    awk -v text="$2" -v square="$square" -v absolute="$absolute" -v share="$share" -v a="$(mean "$a" --ch R,G,B)" \
        -v b="$(mean "$b" --ch R,G,B)" 'BEGIN {
        printf "| %s | %.4f | %.1f %% | %.1f %% |\n", text, a / b, 100 * absolute / b,
            100 * sqrt(square / share) / (b / share) }'
}

# compare NAME TEXT LIGHT ALPHA_X ALPHA_Y COLOR SHADER SCATTERING MATERIAL [FLAG...]. LIGHT: sky, strip or both.
compare() {
    name=$1 text=$2 light=$3 x=$4 y=$5 color=$6 shader=$7 scattering=$8 material=$9
    shift 9
    case $light in strip) lit=none strip=8 ;; both) lit=$environment strip=8 ;; *) lit=$environment strip=0 ;; esac
    by_burnish "$name" "$lit" $strip "\"alpha_x\": $x, \"alpha_y\": $y, $material" "$@"
    sky=
    [ "$lit" = none ] || sky=env=$environment
    by_cycles "$name" alpha="$x,$y" color="$color" shader="$shader" scattering="$scattering" strip="$strip" \
        ${sky:+"$sky"}
    figures "$name" "$text"
}

white='"metallic": 1, "base_color": [1, 1, 1]'
single='"metallic": 1, "base_color": [1, 1, 1], "single_scattering": true'
steel='0.6045,0.5867,0.5679'
gold='1,0.7727,0.3399'
echo "| surface | light | scattering | energy | mean difference | rms |"
echo "|---|---|---|---|---|---|"
for pair in "0.1 0.4" "0.3 0.1" "0.2 0.2"; do
    # shellcheck disable=SC2086  # two words
    set -- $pair
    compare "white-$1-strip" "reflects all, $1 x $2 | strip | single" strip "$1" "$2" 1,1,1 anisotropic single "$single"
    compare "white-$1-sky" "reflects all, $1 x $2 | sky | single" sky "$1" "$2" 1,1,1 anisotropic single "$single"
    compare "white-$1-multiple" "reflects all, $1 x $2 | sky | multiple" sky "$1" "$2" 1,1,1 anisotropic multiple \
        "$white"
done
compare steel-schlick "steel's color, 0.1 x 0.4 | both | multiple" both 0.1 0.4 $steel principled multiple \
    "\"metallic\": 1, \"base_color\": [$steel]"
compare gold-schlick "gold's color, 0.3 x 0.1 | both | multiple" both 0.3 0.1 $gold principled multiple \
    "\"metallic\": 1, \"base_color\": [$gold]"
compare steel "metal steel, 0.1 x 0.4 | both | multiple" both 0.1 0.4 $steel principled multiple '"metal": "steel"'
compare gold "metal gold, 0.3 x 0.1 | both | multiple" both 0.3 0.1 $gold principled multiple '"metal": "gold"'

# Cycles against itself with another seed: noise alone makes the last two columns, times the square root of 2.
by_cycles noise alpha=0.1,0.4 color=$steel shader=principled scattering=multiple strip=8 env="$environment" seed=1
cp "$out/steel.cycles.exr" "$out/noise.burnish.exr"
figures noise "Cycles twice, 0.1 x 0.4 | both | multiple"

# The sheet: Burnish, Cycles, and four times the difference about gray.
set --
for metal in steel gold; do
    for program in burnish cycles; do
        oiiotool "$out/$metal.$program.exr" --ch R,G,B --colorconvert linear srgb -o "$out/$metal.$program.ppm"
        set -- "$@" "$out/$metal.$program.ppm"
    done
    oiiotool "$out/$metal.burnish.exr" --ch R,G,B "$out/$metal.cycles.exr" --ch R,G,B --sub --mulc 4 --addc 0.2 \
        --colorconvert linear srgb -o "$out/$metal.difference.ppm"
    set -- "$@" "$out/$metal.difference.ppm"
done
oiiotool "$@" --mosaic 3x2 -o "$out/cycles.ppm"
# cjpeg writes no metadata, which a test asks for.
cjpeg -quality 85 "$out/cycles.ppm" >"$out/cycles.jpg"
