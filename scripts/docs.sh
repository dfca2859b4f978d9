#!/bin/sh
# Builds the site of docs/ and of the public headers into build/site. Usage: docs.sh
set -eu
cd "$(dirname "$0")/.."
site=build/site
version=$(sed -n 's/.*project(burnish.*VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt | head -n 1)

rm -rf $site
mkdir -p build
# The entry of the headers' reference leads into what doxygen adds below; mkdocs remarks on it.
mkdocs build --quiet --config-file mkdocs.yml --site-dir "$PWD/$site" 2>&1 |
    grep -v "relative path to 'api/index.html' is included in the 'nav'" >&2 || true
[ -f $site/index.html ] || exit 1
{
    cat Doxyfile
    echo "OUTPUT_DIRECTORY = $site"
    echo "PROJECT_NUMBER = $version"
} | doxygen -
[ -f $site/api/index.html ] || exit 1
echo "Look at $site/index.html"
