#!/usr/bin/env bash
# The main job from nothing: installs what is missing, builds, makes a database, and tracks with it.
#   scripts/demo.sh                      renders evaluation sequences with noise and tracks them
#   scripts/demo.sh VIDEO [OPTIONS ...]  tracks that video; options go to `graspdb track`
set -euo pipefail
video=${1:+$(realpath "$1")}
shift || true
cd "$(dirname "$0")/.."

scripts/install.sh
cmake --preset release -DGRASPDB_BUILD_TESTS=OFF -DGRASPDB_BUILD_BENCH=OFF >/dev/null
cmake --build --preset release --target graspdb
graspdb=build/release/cli/graspdb
out=out/demo
mkdir -p "$out"

# Free rows too, so that empty hands are known.
"$graspdb" build --objects both --out "$out/hands.graspdb"
"$graspdb" verify "$out/hands.graspdb"
"$graspdb" grasp sheet --all --out "$out/grasps.png"

if [ -n "$video" ]; then
    "$graspdb" track "$out/hands.graspdb" "$video" --json "$out/video.jsonl" --video "$out/video.mp4" "$@"
    echo "overlay: $out/video.mp4   poses: $out/video.jsonl   grasps: $out/grasps.png"
    exit
fi

for sequence in bottle box; do
    "$graspdb" sequence "sequences/test/$sequence.seq.toml" --alpha 0.5 --out "$out/$sequence"
    "$graspdb" track "$out/hands.graspdb" "$out/$sequence" \
        --json "$out/$sequence.jsonl" --video "$out/$sequence.mp4" | tee "$out/$sequence.txt"
done
"$graspdb" index "$out/hands.graspdb" --method lsh
"$graspdb" bench "$out/hands.graspdb"
echo "grasps: $out/grasps.png"
echo "frames, masks and truth: $out/bottle $out/box"
echo "overlays: $out/bottle.mp4 $out/box.mp4   poses: $out/*.jsonl   errors: $out/*.txt"
