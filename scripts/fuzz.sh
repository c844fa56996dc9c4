#!/usr/bin/env bash
# Feeds altered files to the readers of databases, grasp files and rig maps, with the sanitizers on.
#   scripts/fuzz.sh [SECONDS]   for each reader; 30 when absent
# What a run has learned stays in build/fuzz/corpus; an input that breaks a reader ends the script
# and stays in build/fuzz/findings.
set -euo pipefail
seconds=${1:-30}
[[ $seconds =~ ^[1-9][0-9]*$ ]] || {
    echo "fuzz.sh: $seconds: no number of seconds" >&2
    exit 2
}
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh clang libclang-rt-14-dev # of no use to anything else
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz

# fuzz NAME SEEDS ...: NAME_fuzz, from good files of the repository.
fuzz() {
    local name=$1 corpus=build/fuzz/corpus/$1
    shift
    mkdir -p "$corpus" build/fuzz/findings
    cp -- "$@" "$corpus"
    echo "== $name, $seconds s"
    "build/fuzz/tests/fuzz/${name}_fuzz" -max_total_time="$seconds" -timeout=10 -print_final_stats=1 \
        -print_funcs=0 -verbosity=0 -artifact_prefix="build/fuzz/findings/$name-" "$corpus" |&
        sed '/^###### Recommended/,/^###### End/d' # pages that nobody reads
}
fuzz database tests/database/golden/*.graspdb
fuzz grasp grasps/*.toml
fuzz rig_map assets/hands/*.rig.toml
