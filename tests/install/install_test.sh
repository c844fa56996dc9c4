#!/usr/bin/env bash
# Installs a build into a prefix of its own, and uses it as somebody would who never saw the sources.
#   install_test.sh BUILD_FOLDER SOURCE_FOLDER
set -euo pipefail
build=$1 source=$2
unset GRASPDB_DATA
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix share=$work/prefix/share/graspdb
mkdir "$work/user"
cp -r "$source/examples" "$work/user"
cd "$work/user"

fail() {
    echo "install_test.sh: $*" >&2
    exit 1
}
# quietly COMMAND...: it succeeds, and what it says is in the file `said`.
quietly() { "$@" >said 2>&1 || fail "$*: $(cat said)"; }
# says TEXT COMMAND...: it succeeds, and TEXT (a regular expression) is in what it says.
says() {
    quietly "${@:2}"
    grep -Eq -- "$1" said || fail "${*:2}: expected '$1', found: $(cat said)"
}
# misses FILE COMMAND...: it fails, and names that file.
misses() {
    ! "${@:2}" >said 2>&1 || fail "${*:2}: works without $1"
    grep -Fq -- "$1" said || fail "${*:2}: expected '$1', found: $(cat said)"
}
graspdb() { "$prefix/bin/graspdb" "$@"; }

echo "== the data are those of the sources, and nothing else"
quietly cmake --install "$build" --prefix "$prefix"
data() { find "$@" -type f \( -name '*.toml' -o -name '*.obj' -o -name '*.glb' -o -name '*.safetensors' \) ! -name 'webxr_*.glb' | sort; }
diff <(cd "$source" && data assets/descriptors assets/finders assets/hands assets/objects assets/presets grasps sequences/train sequences/test) \
    <(cd "$share" && data assets grasps sequences) || fail "the installed data are others than the sources'"
strangers=$(find "$share" -type f ! -name '*.toml' ! -name '*.obj' ! -name '*.glb' ! -name '*.safetensors' ! -name README.md \
    -o -name 'webxr_*.glb' -o -type d -empty)
[ -z "$strangers" ] || fail "installed, and no data: $strangers"

echo "== the program"
says '^graspdb [0-9.]+$' graspdb --version
says '^ok +hand length' graspdb hand check "$share/assets/hands/male.glb"
says ': 2000 rows, 2000 of them rendered' graspdb build --only 9,27 --views 200 --out hands.graspdb
says '^mug: 13 frames' graspdb sequence "$share/sequences/test/mug.seq.toml" --fps 1 --out mug
says '^13 frames, [1-9][0-9]* with a hand' graspdb track hands.graspdb mug --json poses.jsonl
[ "$(grep -c '"valid":true' poses.jsonl)" -gt 0 ] || fail "no pose in poses.jsonl"
says ': 2000 rows, 2000 of them rendered' graspdb build --only 9,27 --views 200 --out codes.graspdb \
    --descriptor "$share/assets/descriptors/hand.safetensors"
says '^kde alpha 0 % +[0-9]' graspdb eval hands.graspdb --sequences "$share/sequences/test/mug.seq.toml" --fps 1 --alphas 0

echo "== the examples; the tracker links without what only a renderer needs"
configure() { quietly cmake -G Ninja -S "$1" -B "$2" -DCMAKE_PREFIX_PATH="$prefix" "${@:3}"; }
rendering=(embree assimp OpenImageIO nlohmann_json CLI11)
without=("${rendering[@]/#/-DCMAKE_DISABLE_FIND_PACKAGE_}")
configure examples built -DCMAKE_BUILD_TYPE=Release "${without[@]/%/=ON}"
quietly cmake --build built
[ ! -e built/03_render ] || fail "03_render was built without Embree"
configure examples built "${without[@]/%/=OFF}"
quietly cmake --build built
says '^row 7: grasp [0-9]+, view 7, squared distance 0$' built/01_nearest hands.graspdb 7 3
says '^row 7: grasp [0-9]+, view 7, squared distance 0$' built/01_nearest codes.graspdb 7 3
says 'grasp (9|27), confidence' built/02_track hands.graspdb mug/frames/*.png
says 'grasp (9|27), confidence' env GRASPDB_DATA="$share" built/02_track codes.graspdb mug/frames/*.png
says 'index fingertip at pixel' built/03_render pinch
[ -s pinch/view.json ] || fail "03_render wrote no view.json"

echo "== as a folder of another project"
mkdir parent
cat >parent/CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(parent LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(GRASPDB_RUNTIME_ONLY ON)
add_subdirectory("$source" graspdb)
add_executable(user ../examples/01_nearest.cpp)
target_link_libraries(user PRIVATE graspdb::tracker)
END
configure parent parent/built -DCMAKE_DISABLE_FIND_PACKAGE_embree=ON
! grep -e -Werror -e "$source/tests/" parent/built/compile_commands.json || fail "warnings are errors, or tests are built"
! grep '01_nearest.cpp' parent/built/compile_commands.json | grep -e -ffp-contract -e -Wall ||
    fail "the user's own code has graspdb's options"

echo "== an installation uses its own data, and not those of the sources"
rm "$share/assets/hands/male.glb"
misses "$share/assets/hands/male.glb" graspdb build --only 9 --steps 1 --views 1 --out none.graspdb
misses "$share/assets/hands/male.glb" built/03_render none
