#!/bin/sh
# clang-tidy by .clang-tidy. Usage: tidy.sh [all | FILE...]
# Without arguments: the sources that differ from the branch main, or from the last commit where there
# is no such branch, and the sources that include a header that differs. A header that headers alone
# include is checked with the sources that include those. JOBS: the number of processes.
set -eu
cd "$(dirname "$0")/.."
build=build/tidy

base=$(git merge-base HEAD main 2>/dev/null || git rev-parse HEAD)

# The files with this ending that differ from $base, one a line.
changed() { git diff --name-only --diff-filter=d "$base" -- "src/*.$1" "include/*.$1" "papers/*.$1" "bench/*.$1"; }

# The sources and headers that include a header of this name, one a line. The folder is not compared:
# an include may leave it out, and a source too many costs seconds.
users() { git grep -lE "^#include [<\"]([a-z0-9_/]+/)?$(basename "$1")[>\"]" -- src include papers bench || true; }

# The sources that differ, and the users of the headers that differ.
changed_sources() {
    changed cpp
    headers="$(changed hpp) $(changed inc)"
    seen=
    while [ -n "${headers# }" ]; do
        above=
        for header in $headers; do
            case " $seen " in *" $header "*) continue ;; esac
            seen="$seen $header"
            found=$(users "$header")
            sources=$(printf '%s\n' "$found" | grep '\.cpp$' || true)
            if [ -n "$sources" ]; then
                printf '%s\n' "$sources"
            else
                above="$above $(printf '%s' "$found" | tr '\n' ' ')"
            fi
        done
        headers=${above# }
    done
}

case ${1:-} in
    all) files=$(git ls-files 'src/*.cpp' 'papers/*.cpp' 'bench/*.cpp') ;;
    "") files=$(changed_sources | sort -u) ;;
    *) files=$* ;;
esac
[ -n "$files" ] || {
    echo "tidy: no source differs from $base"
    exit 0
}

cmake --preset tidy >/dev/null
# shellcheck disable=SC2086  # the list is meant to be split
printf '%s\n' $files | xargs -P "${JOBS:-$(nproc)}" -n 1 clang-tidy-14 -p $build --quiet
echo "tidy: clean"
