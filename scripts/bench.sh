#!/bin/sh
# Measures the budgets and keeps the result. Usage: bench.sh BUILD_FOLDER
set -eu
mkdir -p bench/results
out=bench/results/$(date +%Y-%m-%d)-$(uname -n | cut -d. -f1).md
"$1/bin/burnish_bench" "$out"
echo
echo "written to $out"
