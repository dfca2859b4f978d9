#!/bin/sh
# Installs the packages of a list in this folder that are missing, and nothing when none is.
# Usage: install_packages.sh [LIST]   (default: packages.txt)
set -eu
list=${1:-packages.txt}
folder=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
wanted=$(sed 's/#.*//' "$folder/$list" | tr -s ' \n' ' ')

missing=""
for package in $wanted; do
    status=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
    [ "$status" = "install ok installed" ] || missing="$missing $package"
done
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null; then
    echo "burnish: no apt-get here; install these yourself (Debian 12 names):$missing" >&2
    exit 1
fi
as_root=""
if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || {
        echo "burnish: packages are missing and neither root nor sudo is at hand:$missing" >&2
        exit 1
    }
    as_root="sudo"
fi
echo "burnish: installing$missing"
# shellcheck disable=SC2086  # the list is meant to be split
{
    $as_root apt-get update -q
    $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
        $missing
}
