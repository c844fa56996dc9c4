#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs MediaPipe Hands over the photoreal frames and scores it as graspdb is scored (docs/peers.md). Goes on where it
# was when it is started again with the same --out.
#   scripts/peers/mediapipe.sh [--set test|train] [--database DB] [--out DIR] [OPTIONS of graspdb track]
# With --database graspdb reads the same frames and is in the same table. GRASPDB names the program when it is built.
set -euo pipefail

set=test database='' out='' others=()
while [ $# -gt 0 ]; do
    case $1 in
        --set) set=$2 && shift 2 ;;
        --database) database=$(realpath -e -- "$2") && shift 2 ;;
        --out) out=$(realpath -m -- "$2") && shift 2 ;;
        *) others+=("$1") && shift ;;
    esac
done
[[ $set =~ ^(train|test)$ ]] || {
    echo "mediapipe.sh: --set $set: expected train or test" >&2
    exit 2
}
[ -n "$database" ] || [ ${#others[@]} -eq 0 ] || {
    echo "mediapipe.sh: ${others[*]}: options of graspdb track, which needs --database" >&2
    exit 2
}
cd "$(dirname "$0")/../.."
out=${out:-$PWD/out/peers}
frames=sequences/photoreal/$set
names=$(ls "$frames")

scripts/install.sh chromium nodejs python3-numpy # of no use to anything else
command -v npm >/dev/null || scripts/install.sh npm # a nodejs that is not Debian's brings its own
scripts/fetch_hands.sh
graspdb=${GRASPDB-}
if [ -z "$graspdb" ]; then
    scripts/install.sh
    cmake --preset release >/dev/null
    cmake --build --preset release --target graspdb
    graspdb=build/release/cli/graspdb
fi

packages=("@mediapipe/hands@0.4.1675469240" puppeteer-core@24.43.1)
if [ "$(cat "$out/packages/ready" 2>/dev/null)" != "${packages[*]}" ]; then
    mkdir -p "$out/packages"
    npm install --prefix "$out/packages" --ignore-scripts --no-audit --no-fund --loglevel=error "${packages[@]}"
    echo "${packages[*]}" >"$out/packages/ready"
fi

# write_truth NAME: of the rendered sequence only the numbers are kept
write_truth() {
    local truth=$out/$set/truth/$1
    [ ! -d "$truth" ] || return 0
    mkdir -p "$out/$set/truth.part"
    "$graspdb" sequence "sequences/$set/$1.seq.toml" --out "$out/$set/truth.part/$1"
    rm -r "$out/$set/truth.part/$1"/{frames,masks,noisy}
    mkdir -p "$out/$set/truth"
    mv "$out/$set/truth.part/$1" "$truth"
}

# ask_mediapipe NAME
ask_mediapipe() {
    local result=$out/$set/mediapipe/$1.jsonl
    [ ! -f "$result" ] || return 0
    mkdir -p "$out/$set/mediapipe"
    node scripts/peers/mediapipe.mjs "$out/packages" "$frames/$1" "$result.part"
    mv "$result.part" "$result"
}

# ask_graspdb NAME HANDEDNESS FOLDER
ask_graspdb() {
    local result=$3/$1.jsonl focal status=0
    [ ! -f "$result" ] || return 0
    mkdir -p "$3"
    focal=$(sed -n 's/^focal_px *= *\([0-9.]*\).*/\1/p' "sequences/$set/$1.seq.toml")
    "$graspdb" track "$database" "$frames/$1" --focal "$focal" --handedness "$2" --json "$result.part" \
        "${others[@]}" || status=$?
    [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || exit "$status" # 3: no frame had a hand, which is a result
    mv "$result.part" "$result"
}

tracks=("MediaPipe=$out/$set/mediapipe")
for name in $names; do
    write_truth "$name"
    ask_mediapipe "$name"
done
if [ -n "$database" ]; then
    # Results of another database, or of other options, are other results.
    key=$({ stat -c '%n %s %Y' "$database" && echo "${others[*]}"; } | cksum | cut -d ' ' -f 1)
    for handedness in right auto; do
        folder=$out/$set/graspdb-$key-$handedness
        for name in $names; do ask_graspdb "$name" "$handedness" "$folder"; done
        tracks+=("graspdb, $handedness=$folder")
    done
fi
/usr/bin/python3 -B scripts/peers/score.py "$out/$set/truth" "${tracks[@]}" --json "$out/$set/scores.json"
