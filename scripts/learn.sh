#!/usr/bin/env bash
# Trains a learned descriptor, from nothing or from a file of weights, measured on the training sequences. Goes on
# where it was when it is started again with the same --out.
#   scripts/learn.sh [--minutes M] [--out FILE] [--sequences DIR|none] [OPTIONS of scripts/learn/train.py]
# Beside FILE.work lie the shards, the checkpoint and what is measured: 1.5 GB, to be deleted at will.
set -euo pipefail
cd "$(dirname "$0")/.."

out=out/learn/learned.safetensors
minutes=75
sequences=sequences/train
others=()
while [ $# -gt 0 ]; do
    case $1 in
        --out) out=$2 && shift 2 ;;
        --minutes) minutes=$2 && shift 2 ;;
        --sequences) sequences=$2 && shift 2 ;;
        *) others+=("$1") && shift ;;
    esac
done
[[ " ${others[*]} " == *" --crops "* ]] || others+=(--minutes "$minutes")
[ "$sequences" = none ] || others+=(--sequences "$sequences")

scripts/install.sh
scripts/install.sh python3-torch # of no use to anything else
cmake --preset release >/dev/null
cmake --build --preset release --target graspdb
mkdir -p "$(dirname "$out")"
exec /usr/bin/python3 -B scripts/learn/train.py --program build/release/cli/graspdb --work "$out.work" --out "$out" "${others[@]}"
