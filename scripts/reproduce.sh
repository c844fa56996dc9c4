#!/usr/bin/env bash
# Makes the database, tracks a set of sequences through segmentation noise, and draws what came out.
#   scripts/reproduce.sh [train|test]   train when absent: the test set is for telling, not for choosing
# Everything lands in out/reproduce/SET: tables (eval.txt), eval.json, frames.csv, runs.csv, plots, the map of
# confused types, and a page (report.html) on which each sequence plays frame by frame.
set -euo pipefail
set=${1:-train}
[[ $set =~ ^(train|test)$ ]] || {
    echo "reproduce.sh: $set: expected train or test" >&2
    exit 2
}
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh python3-matplotlib python3-opencv # of no use to anything else
scripts/fetch_hands.sh
cmake --preset release >/dev/null
cmake --build --preset release --target graspdb
graspdb=build/release/cli/graspdb
out=out/reproduce/$set
mkdir -p "$out"

"$graspdb" build --objects both --out out/reproduce/hands.graspdb
"$graspdb" eval out/reproduce/hands.graspdb --sequences "sequences/$set" --alphas 0,0.25,0.5,1,2,4 --out "$out" |
    tee "$out/eval.txt"
/usr/bin/python3 scripts/plot_evaluation.py "$out" --out "$out/plots"
/usr/bin/python3 scripts/confusability.py out/reproduce/hands.graspdb --out "$out/plots/confusability.png"
for sequence in "sequences/$set"/*.seq.toml; do
    "$graspdb" sequence "$sequence" --alpha 0.5 --out "$out/rendered/$(basename "$sequence" .seq.toml)"
done
/usr/bin/python3 scripts/report.py "$out" --db out/reproduce/hands.graspdb --sequences "$out"/rendered/* \
    --out "$out/report.html"
echo "tables: $out/eval.txt   plots: $out/plots   page: $out/report.html"
