# shellcheck shell=sh disable=SC2034  # sourced: the scripts that source it use its variables
# Sourced by the scripts that render pictures of their own: NAME.sh BURNISH FOLDER [SIDE [SAMPLES]].
# $default_side: pixels a side when none is given.
set -eu
burnish=$1
out=$2
side=${3:-$default_side}
samples=${4:-32}
mkdir -p "$out"
