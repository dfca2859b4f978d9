#!/bin/sh
# The checks that need no build: format of the C++ sources, shell scripts. Usage: check.sh
set -eu
cd "$(dirname "$0")/.."
git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 --dry-run -Werror
echo "format: clean"
git ls-files '*.sh' .ci/run | xargs shellcheck --external-sources
echo "shell scripts: clean"
