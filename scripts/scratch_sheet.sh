#!/bin/sh
# Every scratch preset as maps, and on a sphere and a plate, lit from the side and by an environment.
# Usage: scratch_sheet.sh BURNISH FOLDER [SIDE [SAMPLES]]
default_side=640
# shellcheck source=scripts/picture_arguments.sh
. "$(dirname "$0")/picture_arguments.sh"

# A polished base shows every scratch; brushed metals have finer grooves than the map holds, which is
# what their anisotropic base is for.
picture() { # preset model light-or-environment name
    case $1 in
        brushed | tool-marks) base="--alpha-x 0.09 --alpha-y 0.22 --scratch-direction follow" ;;
        circular-brushed) base="--alpha-x 0.09 --alpha-y 0.3 --scratch-direction follow" ;;
        *) base="--alpha-x 0.14" ;;
    esac
    case $2 in
        plane) view="--camera-azimuth 8 --camera-elevation 28" turn=260 ;;
        sphere) turn=0; [ "$1" = circular-brushed ] && view="--camera-azimuth 80 --camera-elevation 15" ||
            view="--camera-azimuth 30 --camera-elevation 15" ;;
    esac
    case $3 in
        side) light="--env none --light 10,-5,2 --light 75,35,3 --background-color #181818" ;;
        # A plate sees one part of the room only: that with the lamp.
        *) light="--env builtin:studio --environment-rotation $turn" ;;
    esac
    # shellcheck disable=SC2086  # the options are meant to be split
    "$burnish" render "builtin:$2" --scratch "$1" --metal steel $base $view $light \
        --samples "$samples" --size "${side}x$side" -o "$out/$1_$2_$3.png" >/dev/null
}

for preset in brushed fine-random deep-gouges circular-brushed swirl-marks tool-marks; do
    "$burnish" scratch --preset "$preset" -o "$out/$preset" >/dev/null
    for model in sphere plane; do
        picture "$preset" "$model" side
        picture "$preset" "$model" studio
    done
    echo "$out/$preset/preview.png $out/${preset}_*.png"
done
