#!/bin/sh
# The tests of the parallel parts under the thread sanitizer. Usage: tsan.sh
# Parallel parts: loops and pools of core, tables of rows (through bin/burnish), generated maps, image
# stacks and the match of a capture. tsan.supp names the libraries whose reports are left out.
set -eu
cd "$(dirname "$0")/.."
build=build/tsan
programs="core_tests maps_tests capture_match_tests capture_stack_tests cli_tests"
suites='ParallelFor.*:WorkPool.*:Bumps.*:SlopeMips.*:ScratchFields.*:ScratchMask.*:WeaveMaps.*'
suites="$suites:Match*.*:ImageStack.*:StackCache.*:Table.*"

[ -f $build/build.ninja ] || cmake --preset tsan
# shellcheck disable=SC2086  # the list is meant to be split
cmake --build $build -j "${JOBS:-$(nproc)}" --target $programs
export TSAN_OPTIONS="suppressions=$PWD/scripts/tsan.supp halt_on_error=1 history_size=7"
failed=0
for program in $programs; do
    echo "$program"
    $build/bin/"$program" --gtest_brief=1 --gtest_filter="$suites" || failed=1
done
exit $failed
