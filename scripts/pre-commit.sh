#!/bin/sh
# A hook for git: refuses a commit whose C++ is not formatted or whose shell scripts shellcheck
# refuses. Install: ln -s ../../scripts/pre-commit.sh .git/hooks/pre-commit
set -eu
cd "$(git rev-parse --show-toplevel)"
changed() { git diff --cached --name-only --diff-filter=d -- "$@"; }
sources=$(changed '*.cpp' '*.hpp')
# shellcheck disable=SC2086  # the list is meant to be split
[ -z "$sources" ] || clang-format-14 --dry-run -Werror $sources
shells=$(changed '*.sh' .ci/run)
# shellcheck disable=SC2086  # the list is meant to be split
[ -z "$shells" ] || shellcheck --external-sources $shells
