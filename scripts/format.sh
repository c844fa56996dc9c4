#!/usr/bin/env bash
# Formats every tracked .cpp and .h by .clang-format, with clang-format 14: other versions format
# some lines in another way.
#   scripts/format.sh           rewrites the files
#   scripts/format.sh --check   prints the files that differ; exits with 1 if there are any
# CLANG_FORMAT names the program where it is not called clang-format-14.
set -euo pipefail
[[ $* =~ ^(--check)?$ ]] || {
    echo "format.sh: $*: expected nothing or --check" >&2
    exit 2
}
cd "$(dirname "$0")/.."

[ -n "${CLANG_FORMAT-}" ] || scripts/install.sh clang-format-14
program=${CLANG_FORMAT:-clang-format-14}
version=$("$program" --version)
[[ $version =~ version\ 14\. ]] || {
    echo "format.sh: $program: expected clang-format 14, found '$version'" >&2
    exit 2
}

# format OPTION ...: some files per process, on all cores
format() {
    git ls-files -z -- '*.cpp' '*.h' | xargs -0 -P "$(nproc)" -n 40 "$program" "$@"
}
if [ $# -eq 0 ]; then
    format -i
    exit
fi
report=$(format --dry-run 2>&1) || {
    echo "$report" >&2
    exit 2
}
different=$(sed -n 's/:[0-9]*:[0-9]*: warning: code should be clang-formatted.*//p' <<<"$report" | sort -u)
[ -z "$different" ] || {
    echo "$different"
    echo "format.sh: these files differ from what scripts/format.sh makes of them" >&2
    exit 1
}
