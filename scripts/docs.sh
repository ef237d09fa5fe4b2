#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the API reference of fixedpoint, engine and firmware with Doxygen (scripts/Doxyfile), and
# checks it: a public name without documentation is an error.
#
# Usage: scripts/docs.sh [FOLDER]
#   FOLDER  where to write it (default: build/docs); begin with FOLDER/html/index.html
# Exit status: 0; 1 if a name is not documented or a comment is malformed; 2 for a wrong call.
set -euo pipefail

case ${1:-} in
    --help) sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"; exit 0 ;;
    -*) echo "docs.sh: unknown argument '$1'; see --help" >&2; exit 2 ;;
esac
if [ $# -gt 1 ]; then
    echo "docs.sh: takes one folder, not $#; see --help" >&2
    exit 2
fi
folder=$(realpath -m -- "${1:-$(dirname "$0")/../build/docs}")
cd "$(dirname "$0")/.."
command -v doxygen >/dev/null || { echo "docs.sh: doxygen is missing; scripts/setup.sh --tests installs it" >&2; exit 2; }
mkdir -p "$folder"
# The last line for a key counts.
{ cat scripts/Doxyfile && echo "OUTPUT_DIRECTORY = \"$folder\""; } | doxygen - || exit 1
echo "$folder/html/index.html"
