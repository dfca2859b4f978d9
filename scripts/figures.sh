#!/bin/sh
# Figures 5, 9, 12 and 15 of K11 (docs/evidence/figures.md), each as one sheet with difference images.
# Usage: figures.sh BURNISH FOLDER [SIDE [SAMPLES]]
default_side=480
# shellcheck source=scripts/picture_arguments.sh
. "$(dirname "$0")/picture_arguments.sh"

shirley="--mdf ashikhmin-shirley --brdf ashikhmin-shirley --e-x 200 --e-y 10"
ward="--mdf ward --brdf ward --alpha-x 0.1 --alpha-y 0.45"
sheet() { # name methods options...
    name=$1 methods=$2
    shift 2
    "$burnish" render "$@" --compare "$methods" --size "${side}x$side" --samples "$samples" \
        -o "$out/$name.png" >/dev/null
    echo "$out/$name.png"
}

# shellcheck disable=SC2086  # the options are meant to be split
{
    # What a normal map makes of an anisotropic surface that it only tells its normals.
    sheet k11-fig5 none,normal-map builtin:torus --normal-map builtin:bumps --uv-scale 2 \
        --metal steel $shirley
    # The same bumps with the distribution deformed along.
    sheet k11-fig9 normal-map,deform-smooth builtin:sphere --normal-map builtin:bumps \
        --metal steel $shirley
    # A scratch map: light scatters along the rim of the highlight.
    sheet k11-fig12 normal-map,deform-smooth builtin:sphere --scratch fine-random \
        --metal steel $shirley --env none --light 20,35,1
    # Close up, on Ward's model and on Ashikhmin and Shirley's.
    sheet k11-fig15-ward normal-map,deform-smooth builtin:sphere --scratch deep-gouges \
        --metal steel $ward --camera-distance 1.6
    sheet k11-fig15-ashikhmin-shirley normal-map,deform-smooth builtin:sphere \
        --scratch deep-gouges --metal steel $shirley --camera-distance 1.6
}
