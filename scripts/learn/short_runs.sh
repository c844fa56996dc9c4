#!/usr/bin/env bash
# What each way in which the training pictures vary is worth, and how far seeds differ: short trainings one after
# the other, each some five minutes of two cores. Runs that are there are not run again.
#   scripts/learn/short_runs.sh OUT [CROPS]      writes OUT/NAME.safetensors and OUT/NAME.log, then tables of all
# CROPS are the pictures of a training, 360,000 when absent.
set -euo pipefail
out=$(realpath -m "${1:?usage: scripts/learn/short_runs.sh OUT [CROPS]}")
crops=${2:-360000}
cd "$(dirname "$0")/../.."
mkdir -p "$out"

run() { # NAME [KEY=VALUE of the samples' configuration ...] [-- OPTIONS of train.py]
    local name=$1 work=$out/$1.safetensors.work
    shift
    [ ! -f "$out/$name.safetensors" ] || return 0
    mkdir -p "$work"
    : >"$work/config.toml"
    # What is measured on is made once.
    for made in "$out"/all.safetensors.work/{references,frames,photoreal}.safetensors; do
        [ ! -f "$made" ] || [ -f "$work/${made##*/}" ] || ln "$made" "$work/"
    done
    while [ $# -gt 0 ] && [ "$1" != -- ]; do echo "$1" >>"$work/config.toml" && shift; done
    scripts/learn.sh --out "$out/$name.safetensors" --crops "$crops" --config "$work/config.toml" \
        --photoreal sequences/photoreal/train "${@:2}" |& tee "$out/$name.log"
    rm -f "$work"/shard*
}

run all
run random-weights -- --rate 0 --crops 24000
run seed-1 -- --seed 1
run seed-2 -- --seed 2
run even-hands made_hands=0
run no-gestures gestures=0
run no-mixtures mixtures=0
run exact-grasps angles_deg=0 wrist_deg=0
run no-forearm forearm_mm=0
run light-of-rows light=0
run even-skin skin=0
run perfect-camera sensor=0
run true-masks true_masks=1
run no-occluders occluders=0
run scene -- --planes gray,mask,scene
run bytes-64 -- --size 64
run no-contrast -- --contrast 0
unseen=(3 9 15 21 27 33)
run unseen-grasps "leave_out=[$(IFS=, && echo "${unseen[*]}")]"
/usr/bin/python3 -B scripts/learn/tell_runs.py "$out"/*.safetensors

echo "Pictures of grasps ${unseen[*]} alone, which unseen-grasps has never seen and whose rows are among the references:"
mkdir -p "$out/unseen/grasps"
for number in "${unseen[@]}"; do cp grasps/"$(printf %02d "$number")"_*.toml "$out/unseen/grasps"; done
printf '%s\n' 'grasps="grasps"' held=1 true_masks=1 occluders=0 >"$out/unseen/queries.toml"
/usr/bin/python3 -B scripts/learn/measure_weights.py --program build/release/cli/graspdb --work "$out/unseen" \
    --config "$out/unseen/queries.toml" "$out"/{all,seed-1,seed-2,unseen-grasps}.safetensors
