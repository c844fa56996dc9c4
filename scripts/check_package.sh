#!/usr/bin/env bash
# Makes the Debian package, installs it in a bare Debian 12 and runs it there. As root: it uses chroot.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh debootstrap dpkg-dev
build=build/package # its own, for the prefix of packages
cmake --preset release -B "$build" -DCMAKE_INSTALL_PREFIX=/usr \
    -DGRASPDB_BUILD_TESTS=OFF -DGRASPDB_BUILD_BENCH=OFF >/dev/null
cmake --build "$build"
rm -f "$build"/*.deb
(cd "$build" && cpack -G DEB)

bare=$(mktemp -d)
trap 'umount -q "$bare/proc" || true; rm -rf --one-file-system "$bare"' EXIT
debootstrap --variant=minbase bookworm "$bare" >/dev/null
mount -t proc proc "$bare/proc"
cp "$build"/*.deb "$bare/root"
chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin DEBIAN_FRONTEND=noninteractive bash -euxo pipefail -c '
    apt-get install -y -qq --no-install-recommends /root/*.deb >/dev/null
    cd /root
    graspdb --help
    graspdb hand check /usr/share/graspdb/assets/hands/male.glb
    graspdb build --only 9,27 --views 200 --out hands.graspdb
    graspdb sequence /usr/share/graspdb/sequences/test/mug.seq.toml --fps 1 --out mug
    graspdb track hands.graspdb mug --json poses.jsonl --video overlay.mp4
    dpkg --verify graspdb
    apt-get purge -y -qq graspdb >/dev/null
    [ ! -e /usr/share/graspdb ]'
