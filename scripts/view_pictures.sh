#!/bin/sh
# Makes the pictures of docs/guide/viewer.md and README.md again. Usage: view_pictures.sh BUILD_FOLDER
# Needs xvfb, burnish-view, oiiotool and cjpeg.
set -eu
cd "$(dirname "$0")/.."
view=$1/bin/burnish-view
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/script.txt" <<END
wait rest
screenshot $folder/view-first.png
set normal_map builtin:bumps
unset scratch
set uv_scale 2
light 20,35
wait rest
compare split normal-map follow-grain
wait rest
screenshot $folder/view-split.png
compare off
pick 560 300
wait rest
wait 4
screenshot $folder/view-lobe.png
panel scene on
set method normal-map
view highlight-error
wait rest
screenshot $folder/view-error.png
view albedo
compare split normal-map follow-grain rotate-approx deform-smooth
wait rest
screenshot $folder/view-albedo.png
END
xvfb-run -a -s "-screen 0 1280x720x24" "$view" --size 1280x720 --state none --script "$folder/script.txt"
for name in view-first view-split view-lobe view-error view-albedo; do
    oiiotool "$folder/$name.png" --resize 960x540 -o "$folder/small.ppm"
    # cjpeg writes no metadata, which a test asks for.
    cjpeg -quality 80 "$folder/small.ppm" >"docs/images/$name.jpg"
done
