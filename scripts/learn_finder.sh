#!/usr/bin/env bash
# Trains a finder of hands from nothing: draws scenes, has Blender photograph them, learns. Goes on where it was when
# it is started again with the same --out.
#   scripts/learn_finder.sh [--scenes N] [--out FILE] [OPTIONS of scripts/learn/train_finder.py]
# Beside FILE.work lie scenes, photographs and the checkpoint: 2 MB a scene, to be deleted at will.
set -euo pipefail
cd "$(dirname "$0")/.."

out=out/learn/finder.safetensors
scenes=1200
others=()
while [ $# -gt 0 ]; do
    case $1 in
        --out) out=$2 && shift 2 ;;
        --scenes) scenes=$2 && shift 2 ;;
        *) others+=("$1") && shift ;;
    esac
done
work=$out.work

scripts/install.sh
scripts/install.sh blender python3-numpy python3-opencv python3-torch # of no use to anything else
cmake --preset release >/dev/null
cmake --build --preset release --target graspdb
graspdb=build/release/cli/graspdb
mkdir -p "$work"

if [ ! -f "$work/scenes.$scenes" ]; then
    "$graspdb" scenes --count "$scenes" --out "$work/scenes"
    touch "$work/scenes.$scenes"
fi
processes=$(nproc) renderers=()
for ((i = 0; i < processes; i++)); do
    blender -b --factory-startup --python-exit-code 1 --python scripts/blender/photoreal_scenes.py -- \
        "$work/scenes" scripts/blender/photoreal.toml "$work/photos" --part "$i/$processes" \
        > >(grep -E "^(scenes:|Error|Traceback| )" || true) &
    renderers+=($!)
done
for renderer in "${renderers[@]}"; do wait "$renderer"; done
exec /usr/bin/python3 -B scripts/learn/train_finder.py --photos "$work/photos" --work "$work" --out "$out" \
    --program "$graspdb" --sequences sequences/train --photoreal sequences/photoreal/train "${others[@]}"
