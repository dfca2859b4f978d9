#!/bin/sh
# Random actions in the window of `burnish view` under the sanitizers, on a virtual display.
# Usage: soak_view.sh [SECONDS [SEED]]   (default: 900 seconds, the seed by the clock)
# Builds with the preset `asan`. Fails on any finding and when the script ends early; prints the
# resident memory at the start, in the middle and at the end. The script and its log stay in
# build/soak_view. BUILD names another build folder that is built already.
set -eu
cd "$(dirname "$0")/.."
seconds=${1:-900}
seed=${2:-$(date +%s)}
build=${BUILD:-build/asan}
out=build/soak_view
command -v xvfb-run >/dev/null || {
    echo "soak_view: expected xvfb-run, found none: install the packages xvfb and xauth" >&2
    exit 1
}

[ -f "$build/build.ninja" ] || cmake --preset asan
cmake --build "$build" -j "${JOBS:-$(nproc)}" --target burnish_view view_script
mkdir -p $out
saved=$(mktemp -d)
trap 'rm -rf "$saved"' EXIT
"$build/bin/view_script" "$seed" "$seconds" "$saved" >$out/script.txt

echo "soak of the viewer: $seconds s, seed $seed"
# Freed memory is held back for 32 MiB, as in the other soak: more looks like growth. Mesa and
# fontconfig leave blocks behind, so that leaks show as growth alone.
code=0
ASAN_OPTIONS=detect_leaks=0:quarantine_size_mb=32 UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 \
    xvfb-run -a -s "-screen 0 1280x1024x24" "$build/bin/burnish-view" --size 480x360 --state none \
    --script $out/script.txt >$out/log.txt 2>$out/findings.txt || code=$?

awk '$1 == "memory_mb" { value[++n] = $2 }
     END { if (n) printf "resident memory, MB: %.0f at the start, %.0f after a quarter, %.0f in the middle, %.0f at the end; %d looks\n",
           value[1], value[int((n + 3) / 4)], value[int((n + 1) / 2)], value[n], n }' $out/log.txt
if [ $code -ne 0 ] || [ -s $out/findings.txt ]; then
    echo "soak_view: exit code $code, expected 0 and no finding; $out/findings.txt begins:" >&2
    head -n 40 $out/findings.txt >&2
    exit 1
fi
echo "no finding"
