#!/usr/bin/env bash
# The main job from nothing: installs what is missing, builds, makes a database, and tracks with it.
#   scripts/demo.sh                      renders evaluation sequences with noise and tracks them
#   scripts/demo.sh VIDEO [OPTIONS ...]  tracks that video, folder of pictures or camera:N; options
#                                        go to `graspdb track`, with absolute paths
set -euo pipefail
case ${1-} in
    "" | camera:*) video=${1-} ;;
    *) video=$(realpath -e -- "$1" 2>/dev/null) || {
        echo "demo.sh: $1: no video, folder of pictures or camera:N" >&2
        exit 2
    } ;;
esac
shift || true
cd "$(dirname "$0")/.."

scripts/install.sh
build=build/demo # its own, so that no other build's options change
cmake --preset release -B "$build" -DGRASPDB_BUILD_TESTS=OFF -DGRASPDB_BUILD_BENCH=OFF >/dev/null
cmake --build "$build" --target graspdb
graspdb=$build/cli/graspdb
out=out/demo
mkdir -p "$out"

"$graspdb" build --preset tracking --out "$out/hands.graspdb"
"$graspdb" verify "$out/hands.graspdb"
"$graspdb" grasp sheet --out "$out/grasps.png"

if [ -n "$video" ]; then
    "$graspdb" track "$out/hands.graspdb" "$video" --json "$out/video.jsonl" --video "$out/video.mp4" "$@"
    echo "overlay: $out/video.mp4   poses: $out/video.jsonl   grasps: $out/grasps.png"
    exit
fi

for sequence in bottle box; do
    "$graspdb" sequence "sequences/test/$sequence.seq.toml" --alpha 0.5 --out "$out/$sequence"
    "$graspdb" track "$out/hands.graspdb" "$out/$sequence" \
        --json "$out/$sequence.jsonl" --video "$out/$sequence.mp4" | tee "$out/$sequence.txt"
    # The same without noise, by every temporal model.
    "$graspdb" eval "$out/hands.graspdb" --sequences "sequences/test/$sequence.seq.toml" --alphas 0 \
        | tee -a "$out/$sequence.txt"
done
"$graspdb" bench "$out/hands.graspdb"
echo "grasps: $out/grasps.png"
echo "frames, masks and truth: $out/bottle $out/box"
echo "overlays: $out/bottle.mp4 $out/box.mp4   poses: $out/*.jsonl   errors: $out/*.txt"
