#!/bin/sh
# Fuzzes the readers, each for so many seconds of one core. Usage: fuzz.sh [SECONDS [READER...]]
#   READER: gltf obj scene csv scratch bsdf image rig tabulated wif (default: all, one after the other)
# Builds with the preset `fuzz`; corpora, logs and findings stay in build/fuzz. Small files of the
# folder that BURNISH_DATA names join the seeds. docs/develop/testing.md says what counts as a finding.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-600}
[ $# -gt 0 ] && shift
readers=${*:-gltf obj scene csv scratch bsdf image rig tabulated wif}
build=build/fuzz
data=${BURNISH_DATA:-../shared/data}

scripts/install_packages.sh packages_check.txt
[ -f $build/build.ninja ] || cmake --preset fuzz
cmake --build $build -j "${JOBS:-$(nproc)}" --target burnish_fuzzers
mkdir -p $build/corpus $build/findings $build/logs
$build/bin/fuzz_seeds $build/seeds

# Seeds from the sample data: files that are whole within -max_len below.
add_data() {
    reader=$1
    shift
    [ -d "$data/models" ] || return 0
    find "$data/models" -type f -size -16k \( "$@" \) | while read -r file; do
        cp -f "$file" "$build/seeds/$reader/data_$(basename "$file")"
    done
}
add_data gltf -name '*.gltf' -o -name '*.glb'
add_data obj -name '*.obj'
add_data image -name '*.png'

# Seconds of processor time that a process has used; nothing once it has ended.
used() {
    awk -v ticks="$(getconf CLK_TCK)" \
        '{ sub(/.*\) /, ""); if ($1 != "Z") print int(($12 + $13) / ticks) }' "/proc/$1/stat" 2>/dev/null
}

# The codec of AVIF leaks a few dozen bytes of a broken file. Nothing else of others is left out.
leaks=$PWD/$build/leaks.txt
echo "leak:libdav1d" >"$leaks"
export LSAN_OPTIONS="suppressions=$leaks:print_suppressions=0"

# SIGUSR1 asks libFuzzer to finish with its statistics.
run() {
    reader=$1
    log=$build/logs/$reader.log
    mkdir -p "$build/corpus/$reader"
    nice -n 5 $build/bin/fuzz_"$reader" -dict=$build/seeds/"$reader".dict -max_len=16384 \
        -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=1024 -print_final_stats=1 \
        -artifact_prefix=$build/findings/"$reader"- \
        "$build/corpus/$reader" "$build/seeds/$reader" >"$log" 2>&1 &
    fuzzer=$!
    trap 'kill $fuzzer 2>/dev/null; exit 130' INT TERM
    spent=0
    while now=$(used $fuzzer) && [ -n "$now" ]; do
        spent=$now
        [ "$spent" -ge "$seconds" ] && kill -USR1 $fuzzer 2>/dev/null
        sleep 2
    done
    status=0
    wait $fuzzer || status=$?
    rm -rf "/dev/shm/burnish-fuzz-$fuzzer" "${TMPDIR:-/tmp}/burnish-fuzz-$fuzzer"
    echo "$reader: $spent s of one core," \
        "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log") executions," \
        "$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1) edges," \
        "$(find $build/findings -name "$reader-*" | wc -l) findings in $build/findings"
    return $status
}

failed=0
for reader in $readers; do run "$reader" || failed=1; done
exit $failed
