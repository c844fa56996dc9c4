#!/usr/bin/env bash
# Renders the photoreal frames that are missing from sequences/photoreal (docs/sequences.md): of those sequences
# that scripts/blender/photoreal.toml has a look for. Nothing is done for frames that are there.
#   scripts/render_photoreal.sh [train|test]    both when absent
set -euo pipefail
sets=("${@:-train}")
[ $# -gt 0 ] || sets=(train test)
for set in "${sets[@]}"; do
    [[ $set =~ ^(train|test)$ ]] || {
        echo "render_photoreal.sh: $set: expected train or test" >&2
        exit 2
    }
done
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh blender python3-numpy python3-opencv # of no use to anything else
scripts/fetch_hands.sh
cmake --preset release >/dev/null
cmake --build --preset release --target graspdb
looks=scripts/blender/photoreal.toml
for set in "${sets[@]}"; do
    for name in $(sed -n "s/^\[$set\.\(.*\)\]$/\1/p" "$looks"); do
        meshes=out/photoreal/$set/$name
        build/release/cli/graspdb sequence "sequences/$set/$name.seq.toml" --meshes "$meshes"
        nice -n 5 blender -b --factory-startup --python-exit-code 1 --python scripts/blender/photoreal.py -- \
            "$meshes" "$looks" "$set" "sequences/photoreal/$set/$name" | { grep -E "^($name|Error|Traceback| )" || true; }
    done
done
du -sh sequences/photoreal
