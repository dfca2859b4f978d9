#!/bin/sh
# The demo: the main job on inputs it makes itself. Usage: demo.sh BURNISH FOLDER
set -eu
burnish=$1
out=$2
methods=none,normal-map,deform-smooth,follow-grain
mkdir -p "$out"

# K11 Fig 9: illusory bumps on a brushed surface. The grain runs along the tangent (e_x > e_y).
"$burnish" render builtin:sphere --normal-map builtin:bumps --metal steel \
    --mdf ashikhmin-shirley --e-x 200 --e-y 10 \
    --compare $methods --size 480x480 --samples 32 -o "$out/sphere.png"
"$burnish" render builtin:drape --normal-map builtin:bumps --metal brass \
    --alpha-x 0.12 --alpha-y 0.45 --uv-scale 2 --normal-scale 0.6 \
    --compare $methods --size 480x400 --samples 32 -o "$out/drape.png"

echo
echo "Look at:"
echo "  $out/sphere.png   a brushed steel sphere with bumps, four methods and their differences"
echo "  $out/drape.png    the same on a metallic cloth"
echo "none ignores the bumps. normal-map collapses and bends the streak of each bump on the sphere, and"
echo "flattens the bumps of the cloth. deform-smooth and follow-grain carry the streak over each bump."
