#!/bin/sh
# Renders a fixed set of small pictures that together use every method, distribution, model, image
# light, map, cloth, table, light and pass. Two programs that render the same sets of pictures mean
# the same by a material: tests/support/compare_pictures.cpp measures the difference.
# Usage: fixed_renders.sh PROGRAM FOLDER [MODEL_FOLDER]
set -eu
program=$1
folder=$2
root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
mkdir -p "$folder"
count=0

# render NAME ARGUMENTS: one picture of 96 x 96 pixels and 4 samples.
render() {
    name=$1
    shift
    count=$((count + 1))
    "$program" render "$@" --size 96x96 --samples 4 -o "$folder/$name.png" ||
        { echo "fixed_renders: $name failed" >&2; exit 1; }
}

bumps="--normal-map builtin:bumps --alpha-x 0.12 --alpha-y 0.45"
for method in none normal-map gram-schmidt rotate-exact rotate-approx rotate-arc follow-grain \
    deform-linear deform-smooth slope-shift stretch; do
    # shellcheck disable=SC2086  # a list of flags
    {
        render "method-$method-light" builtin:sphere $bumps --method "$method" --light 40,50 \
            --env none
        render "method-$method-sky" builtin:sphere $bumps --method "$method"
        render "method-$method-prefiltered" builtin:sphere $bumps --method "$method" \
            --image-light prefiltered
    }
done
for mdf in ashikhmin-shirley ward beckmann ggx; do
    # shellcheck disable=SC2086
    render "mdf-$mdf" builtin:sphere $bumps --mdf "$mdf" --metal copper --light 40,50
done
for brdf in microfacet microfacet-separable ashikhmin-shirley ward-gmd ward ward-duer cook-torrance \
    phong lafortune; do
    # shellcheck disable=SC2086
    render "brdf-$brdf" builtin:torus $bumps --brdf "$brdf" --light 40,50 --metallic 0 \
        --base-color 0.6,0.3,0.1
done
# shellcheck disable=SC2086
{
    render conserve builtin:sphere $bumps --method deform-smooth --conserve --light 40,50
    render bent-normal builtin:sphere $bumps --image-light bent-normal
    render image-light-off builtin:sphere $bumps --image-light off --light 40,50
    render filter-mips builtin:plane $bumps --normal-filter mips --uv-scale 20 --light 40,50
    render filter-moments builtin:plane $bumps --normal-filter moments --uv-scale 20 --light 40,50
    render point-light builtin:drape $bumps --light point:1,2,1 --env none
    render three-lights builtin:torus $bumps --light 0,30 --light 120,30 --light point:0,2,0
    render shadows-ground builtin:torus --ground --light 30,40 --roughness 0.3
    render transparent builtin:cylinder --background transparent --roughness 0.2
    render rotation builtin:sphere --anisotropy 0.8 --anisotropy-rotation 30 --light 40,50
    render scratch-swirl builtin:sphere --scratch swirl-marks --metal steel --alpha-x 0.14
    render scratch-brushed builtin:plane --scratch brushed --metal aluminium --uv-scale 3
}
for weave in plain twill-2-2 satin-5 herringbone; do
    render "weave-$weave-near" builtin:plane --weave "$weave" --weave-yarns 12 --light 40,50
    render "weave-$weave-far" builtin:drape --weave "$weave" --weave-yarns 300
done
render weave-draft builtin:drape --weave "$root/examples/weaves/houndstooth.wif" --weave-yarns 60
table=$folder/table.exr
if [ ! -s "$table" ]; then
    "$program" capture simulate satin --size 16 --lights 8x8 -o "$folder/satin"
    "$program" capture fit "$folder/satin/rig.json" --eta 1.5 -o "$table"
fi
for method in none normal-map follow-grain rotate-approx deform-smooth slope-shift; do
    render "table-$method" builtin:drape --tabulated "$table" --method "$method" --uv-scale 3 \
        --normal-map builtin:bumps --light 40,50
done
render table-sky builtin:drape --tabulated "$table" --uv-scale 3
for scene in "$root"/examples/scenes/*.json; do
    render "scene-$(basename "$scene" .json)" "$scene"
done
if [ $# -gt 2 ]; then
    for model in $(find "$3" -name "*.gltf" -o -name "*.glb" | sort); do
        render "model-$(basename "$model")" "$model"
    done
fi
echo "fixed_renders: $count pictures in $folder"
