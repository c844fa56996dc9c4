#!/usr/bin/env bash
# Runs clang-tidy 14, by .clang-tidy, over the tracked .cpp files and all headers of ours that they include.
#   scripts/lint.sh             all of them
#   scripts/lint.sh PATH ...    those files, or all in those folders; what a branch has changed:
#                               scripts/lint.sh $(git diff --name-only main -- '*.cpp')
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install.sh
scripts/install.sh clang-tidy-14 # of no use to anything else
cmake --preset dev >/dev/null # file by file, as clang-tidy wants it

# Fuzzers and examples are no part of that build.
git ls-files -- "${@:-.}" | grep '\.cpp$' | grep -vE '^(tests/fuzz|examples)/' |
    xargs -P "$(nproc)" -n 1 clang-tidy-14 --quiet -p build/dev 2> >(grep -v 'warnings generated\.$' >&2)
