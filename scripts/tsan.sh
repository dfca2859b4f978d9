#!/bin/sh
# The tests of what runs in parallel, under the thread sanitizer. Usage: tsan.sh
# tsan.supp names the reports that are left out: the libraries that are not compiled with it.
set -eu
cd "$(dirname "$0")/.."
build=build/tsan
programs="core_tests maps_tests capture_match_tests capture_stack_tests"
tests='^(Parallel|WorkPool|Csv|Progress|Scratch|Weave|Rotation|ImageStack|StackCache)'

[ -f $build/build.ninja ] || cmake --preset tsan
# shellcheck disable=SC2086  # the list is meant to be split
cmake --build $build -j "${JOBS:-$(nproc)}" --target $programs
export TSAN_OPTIONS="suppressions=$PWD/scripts/tsan.supp halt_on_error=1 history_size=7"
failed=0
for program in $programs; do
    filter=$($build/bin/"$program" --gtest_list_tests | sed -n 's/^\([A-Za-z]*\)\..*/\1/p' |
        grep -E "$tests" | sed 's/$/.*/' | paste -sd: -)
    [ -z "$filter" ] || $build/bin/"$program" --gtest_brief=1 --gtest_filter="$filter" || failed=1
done
exit $failed
