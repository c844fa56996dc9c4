#!/usr/bin/env bash
# Fetches WebXR's generic hands, right and left, with npm: the hands that nobody here made, for the
# tests of docs/hands.md. They are MIT, (c) 2019 Amazon, and are not kept in this repository; their rig
# maps are. Does nothing when they are here already.
set -euo pipefail
cd "$(dirname "$0")/.."

package=@webxr-input-profiles/assets@1.0.20
hashes="291790c14f7f88a7f9bd35330c47392ed8e8d395ae6728f4bb7089f1bc1f2b96  assets/hands/webxr_right.glb
bc67783144944ea1cda54d9247885825ea5fb9d4651469fe7d00be517a5c2b87  assets/hands/webxr_left.glb"
are_in() { (cd "$1" && sha256sum --check --status <<<"$hashes" 2>/dev/null); }

are_in . && exit 0
command -v npm >/dev/null || {
    echo "fetch_hands.sh: npm is not here; on Debian: apt-get install npm" >&2
    exit 1
}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo "fetching $package (94 MB) with npm, for two files of 94 kB"
npm pack --loglevel=error --pack-destination "$work" "$package" >/dev/null
tar -xzf "$work"/*.tgz -C "$work" package/dist/profiles/generic-hand
mkdir -p "$work/assets/hands"
for side in right left; do
    mv "$work/package/dist/profiles/generic-hand/$side.glb" "$work/assets/hands/webxr_$side.glb"
done
are_in "$work" || {
    echo "fetch_hands.sh: $package holds other hands than it did" >&2
    exit 1
}
mv "$work"/assets/hands/*.glb assets/hands/
