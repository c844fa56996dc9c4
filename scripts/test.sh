#!/usr/bin/env bash
# Checks the format, installs what is missing, builds, and runs every test: Release first, then again
# with the address and undefined-behaviour sanitizers. At the end clang-tidy reads the rooms where it
# is quick, and each reader of files is fuzzed for some seconds.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/format.sh --check
scripts/install.sh
scripts/install.sh python3-torch python3-opencv # of no use to anything but the tests of scripts/learn
# The one hand that nobody here made: its tests are skipped where npm cannot fetch it.
scripts/fetch_hands.sh || echo "WebXR's hands are not here: their tests are skipped"

# build_and_test PRESET TARGET ...
build_and_test() {
    local preset=$1
    shift
    echo "== $preset"
    cmake --preset "$preset" >/dev/null
    cmake --build --preset "$preset" --target "$@"
    ctest --preset "$preset" -j "$(nproc)"
}
build_and_test release all all_verify_interface_header_sets # every header must compile alone, too
build_and_test asan all

scripts/lint.sh core features tracker
scripts/fuzz.sh 5
