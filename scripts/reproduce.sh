#!/usr/bin/env bash
# Makes the databases, tracks a set of sequences through segmentation noise, and draws what came out.
#   scripts/reproduce.sh [train|test] [learned|soft-edges|paper]
# train when absent: the test set is for telling, not for choosing. learned when absent; the others are HOGs.
# Everything lands in out/reproduce/DESCRIPTOR/SET: tables (main.txt, photoreal.txt, finder.txt, true_masks.txt), the paper's
# claims (claims.md), the evaluations (main, photoreal, ...: eval.json, frames.csv, runs.csv), plots, the map of
# confused types, and a page (report.html) on which each sequence plays frame by frame.
set -euo pipefail
set=${1:-train} descriptor=${2:-learned}
[[ $set =~ ^(train|test)$ && $descriptor =~ ^(learned|soft-edges|paper)$ ]] || {
    echo "reproduce.sh: $set $descriptor: expected train or test, and learned, soft-edges or paper" >&2
    exit 2
}
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh python3-matplotlib python3-opencv # of no use to anything else
scripts/fetch_hands.sh
cmake --preset release >/dev/null
cmake --build --preset release --target graspdb
graspdb=build/release/cli/graspdb
databases=out/reproduce/$descriptor
out=$databases/$set
mkdir -p "$out"
alphas=0,0.25,0.5,1,2,4
python=/usr/bin/python3

rows=(--preset tracking)
[ "$descriptor" = learned ] || rows+=(--descriptor none --hog "$descriptor")

build() { "$graspdb" build "${rows[@]}" --objects "$1" --out "$databases/$2.graspdb"; }
evaluate() { # DATABASE OUT OPTIONS...
    "$graspdb" eval "$databases/$1.graspdb" --search exact --sequences "sequences/$set" --out "$2" "${@:3}"
}

build both hands
build held held
build free free
evaluate hands "$out/main" --alphas "$alphas" | tee "$out/main.txt"
evaluate hands "$out/photoreal" --photoreal "sequences/photoreal/$set" --finder redness --alphas "$alphas" | tee "$out/photoreal.txt"
evaluate hands "$out/finder" --photoreal "sequences/photoreal/$set" --alphas 0 | tee "$out/finder.txt"
# The same frames with the hand's true mask.
evaluate hands "$out/true_masks" --photoreal "sequences/photoreal/$set" --true-masks --alphas 0,2 | tee "$out/true_masks.txt"
$python scripts/plot_evaluation.py "$out/main" --out "$out/plots"
$python scripts/plot_evaluation.py "$out/photoreal" --out "$out/plots/photoreal"

# What the claims ask for besides.
evaluate held "$out/held" --alphas 0 >/dev/null
evaluate free "$out/free" --alphas 0 >/dev/null
evaluate hands "$out/seen_hand" --alphas 0 --hand assets/hands/male.glb >/dev/null
evaluate hands "$out/seen_grasp" --alphas 0 --hand assets/hands/male.glb --grasps grasps >/dev/null
"$graspdb" bench "$databases/hands.graspdb" --json >"$out/bench.json"
$python scripts/claims.py --main "$out/main" --held "$out/held" --free "$out/free" --seen-hand "$out/seen_hand" \
    --seen-grasp "$out/seen_grasp" --bench "$out/bench.json" --photoreal "$out/photoreal" --out "$out/claims.md"

$python scripts/confusability.py "$databases/held.graspdb" --out "$out/plots/confusability.png"
$python scripts/worst_frames.py "$out/main" --db "$databases/hands.graspdb" --sequences "sequences/$set" --out "$out/plots/worst.jpg"
for sequence in "sequences/$set"/*.seq.toml; do
    "$graspdb" sequence "$sequence" --alpha 0.5 --out "$out/rendered/$(basename "$sequence" .seq.toml)"
done
$python scripts/report.py "$out/main" --db "$databases/hands.graspdb" --sequences "$out"/rendered/* --out "$out/report.html"
echo "tables: $out/{main,photoreal,finder,true_masks}.txt   claims: $out/claims.md   plots: $out/plots   page: $out/report.html"
