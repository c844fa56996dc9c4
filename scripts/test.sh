#!/usr/bin/env bash
# Checks the format, installs what is missing, builds, and runs every test: Release first, then again
# with the address and undefined-behaviour sanitizers. At the end clang-tidy reads the rooms where it
# is quick, and each reader of files is fuzzed for some seconds.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/format.sh --check
scripts/install.sh
scripts/install.sh python3-torch # of no use to anything but the test of scripts/learn
# The one hand that nobody here made: its tests are skipped where npm cannot fetch it.
scripts/fetch_hands.sh || echo "WebXR's hands are not here: their tests are skipped"
for preset in release asan; do
    echo "== $preset"
    cmake --preset "$preset" >/dev/null
    # Every public header must compile alone, too.
    cmake --build --preset "$preset" --target all all_verify_interface_header_sets
    ctest --preset "$preset" -j "$(nproc)"
done
scripts/lint.sh core features tracker
scripts/fuzz.sh 5
