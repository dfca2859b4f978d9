#!/bin/sh
# Writes the generated pages of docs/ again, from the programs of a build.
# Usage: docs_reference.sh BUILD_FOLDER
set -eu
cd "$(dirname "$0")/.."
bin=$1/bin
"$bin/tabulate_reference" parameters >docs/reference/parameters.md
"$bin/tabulate_reference" cli "$bin/burnish" >docs/reference/cli.md
"$bin/tabulate_correctness" >docs/evidence/correctness.md
echo "written: docs/reference/parameters.md docs/reference/cli.md docs/evidence/correctness.md"
