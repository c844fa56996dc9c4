#!/usr/bin/env bash
# Feeds altered files to every reader of files, with the sanitizers on.
#   scripts/fuzz.sh [SECONDS] [--keep]   for each reader; 30 seconds when absent
# It starts from what earlier runs have learned (tests/fuzz/corpus). An input that breaks a reader
# ends the script and stays in build/fuzz/findings. --keep stores what this run has learned, as few
# inputs as reach the same code.
set -euo pipefail
seconds=${1:-30}
keep=${2:-}
[[ $seconds =~ ^[1-9][0-9]*$ && $keep =~ ^(--keep)?$ ]] || {
    echo "fuzz.sh: $*: expected [SECONDS] [--keep]" >&2
    exit 2
}
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh clang libclang-rt-14-dev # of no use to anything else
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz

# run_fuzzer NAME OPTION ...
run_fuzzer() {
    local name=$1
    shift
    LSAN_OPTIONS=suppressions=tests/leaks.supp:print_suppressions=0 \
        "build/fuzz/tests/fuzz/${name}_fuzz" -timeout=10 -verbosity=0 \
        -artifact_prefix="build/fuzz/findings/$name-" "$@" |&
        sed '/^###### Recommended/,/^###### End/d' # pages that nobody reads
}

keep() {
    local name=$1 least=build/fuzz/least/$1
    rm -rf "$least" && mkdir -p "$least"
    run_fuzzer "$name" -set_cover_merge=1 "$least" "build/fuzz/corpus/$name" >/dev/null
    (cd "$least" && find . -type f -printf '%P\n' | sort |
        xargs python3 -m tarfile -c "$OLDPWD/tests/fuzz/corpus/$name.tar.xz")
}

# fuzz NAME SEEDS ...: NAME_fuzz, from good files of the repository and what is known.
fuzz() {
    local name=$1 corpus=build/fuzz/corpus/$1
    shift
    mkdir -p "$corpus" build/fuzz/findings
    python3 -m tarfile -e "tests/fuzz/corpus/$name.tar.xz" "$corpus"
    [ $# -eq 0 ] || cp -- "$@" "$corpus"
    echo "== $name, $seconds s"
    run_fuzzer "$name" -max_total_time="$seconds" -print_final_stats=1 -print_funcs=0 "$corpus"
    [ -z "$keep" ] || keep "$name"
}
fuzz build_config
fuzz calibration
fuzz closed_poses grasps/closed/*.toml
fuzz database tests/database/golden/*.graspdb
fuzz finder
fuzz grasp grasps/*.toml grasps/examples/*.toml
fuzz hand_file
fuzz object_file
fuzz picture
fuzz pose
fuzz rig_map assets/hands/*.rig.toml
fuzz sequence sequences/*/*.seq.toml
fuzz weights
fuzz written_sequence
