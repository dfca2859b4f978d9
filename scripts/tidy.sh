#!/bin/sh
# clang-tidy by .clang-tidy. Usage: tidy.sh [all | FILE...]
# Without arguments: the sources that differ from the branch main, or from the last commit where there
# is no such branch. A header is checked with the sources that include it.
set -eu
cd "$(dirname "$0")/.."
build=build/tidy

base=$(git merge-base HEAD main 2>/dev/null || git rev-parse HEAD)
case ${1:-} in
    all) files=$(git ls-files 'src/*.cpp' 'papers/*.cpp' 'bench/*.cpp') ;;
    "") files=$(git diff --name-only --diff-filter=d "$base" -- \
        'src/*.cpp' 'papers/*.cpp' 'bench/*.cpp') ;;
    *) files=$* ;;
esac
[ -n "$files" ] || {
    echo "tidy: no source differs from $base"
    exit 0
}

[ -f $build/build.ninja ] || cmake --preset tidy >/dev/null
# shellcheck disable=SC2086  # the list is meant to be split
printf '%s\n' $files | xargs -P "${JOBS:-$(nproc)}" -n 1 clang-tidy-14 -p $build --quiet
echo "tidy: clean"
