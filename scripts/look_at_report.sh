#!/usr/bin/env bash
# Opens a page of scripts/report.py in headless Chromium (scripts/install.sh chromium), fails when its
# script does, and takes a picture of it.
#   scripts/look_at_report.sh report.html shot.png [SEQUENCE,FRAME]
set -euo pipefail
page="file://$(realpath -e -- "$1")#${3-}"
look() {
    # Root's browser has no sandbox; without a display there is no bus to complain about either.
    chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=4000 \
        --window-size=1180,1080 "$@" "$page" 2>/dev/null
}
text=$(look --dump-dom | grep -v '"sequences":')
fault=$(sed -n 's/.*<body data-fault="\([^"]*\)".*/\1/p' <<<"$text")
if [ -n "$fault" ]; then
    echo "look_at_report.sh: $1: $fault" >&2
    exit 1
fi
grep -o '<span id="where">[^<]\+' <<<"$text" | sed 's/.*>/shown: /' || {
    echo "look_at_report.sh: $1: shows no frame" >&2
    exit 1
}
look --screenshot="$(realpath -- "$2")"
