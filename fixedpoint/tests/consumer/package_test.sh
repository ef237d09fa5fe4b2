#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The zip files of scripts/package.sh, installed into a sketchbook of their own as the Arduino IDE
# installs them: the installed examples compile from there, with nothing of the project beside them.
# Usage: package_test.sh SCRATCH_FOLDER
set -euo pipefail
scratch=$1
here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$scratch" && mkdir -p "$scratch/sketchbook/libraries"
"$here/../../../scripts/package.sh" "$scratch/release" >/dev/null
for zip in "$scratch"/release/*.zip; do
    python3 -m zipfile -e "$zip" "$scratch/sketchbook/libraries"
done
for each in "$scratch"/sketchbook/libraries/*; do
    for name in library.properties library.json keywords.txt LICENSE README.md src examples; do
        [ -e "$each/$name" ] || { echo "FAILED: no $name in $(basename "$each")"; exit 1; }
    done
done
LIBRARIES=$scratch/sketchbook/libraries "$here/sketch_test.sh" "$scratch/build" \
    "$scratch"/sketchbook/libraries/fixbench-{fixed-*/examples/printing,lever-*/examples/lever}/*.ino
