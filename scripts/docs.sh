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

# The front page of the headers' reference: every file with the first sentence of its comment.
summary() {
    # shellcheck disable=SC2016  # the backticks are those of the comment
    sed -n '/^\/\//!q; s/^\/\/ \{0,1\}//p' "$1" | tr '\n' ' ' | sed 's/\. [A-Z].*/./; s/[<>@\\]/\\&/g; s/`\([^`]*\)`/<tt>\1<\/tt>/g'
}
{
    echo "/** @mainpage The library's headers"
    echo "<a href=\"../reference/api.html\">Back to the documentation</a>"
    echo "<h2>Headers</h2><table>"
    for file in include/burnish/*.hpp; do
        name=${file#include/}
        echo "<tr><td>@ref ${name##*/} \"$name\"</td><td>$(summary "$file")</td></tr>"
    done
    echo "</table><h2>The maths</h2>"
    echo "In the namespaces burnish::f32 and burnish::f64, and in GLSL. <table>"
    find shading -name '*.glsl' ! -name 'prelude.glsl' | sort | while read -r file; do
        echo "<tr><td>@ref ${file##*/} \"$file\"</td><td>$(summary "$file")</td></tr>"
    done
    echo "</table> */"
} >build/api_main.dox

{
    cat Doxyfile
    echo "INPUT += build/api_main.dox"
    echo "OUTPUT_DIRECTORY = $site"
    echo "PROJECT_NUMBER = $version"
} | doxygen -
[ -f $site/api/index.html ] || exit 1
echo "Look at $site/index.html"
