#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Prints the pages of results/ as one PDF, to be cited.
#
# Usage: scripts/pdf.sh [FILE]     default: build/report.pdf
set -euo pipefail
case ${1-} in
    --help) sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"; exit 0 ;;
    -*) echo "pdf.sh: unknown argument '$1'; see --help" >&2; exit 2 ;;
esac
[ $# -le 1 ] || { echo "pdf.sh: takes one file, not $#" >&2; exit 2; }
root=$(cd "$(dirname "$0")/.." && pwd)
"$root/scripts/setup.sh" --pdf
exec /usr/bin/python3 "$root/bench/report/pdf.py" --results "$root/results" --output "${1:-$root/build/report.pdf}"
