#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes each library as it is published: a tree with the library at its root, as a repository of its
# own needs it, and the zip file that the Arduino IDE installs.
#
# Usage: scripts/package.sh FOLDER    writes FOLDER/NAME-VERSION/ and FOLDER/NAME-VERSION.zip, with
#                                     NAME and VERSION from library.properties
# Files unknown to git are left out. Exit status: 2 for a wrong call.
set -euo pipefail
if [ "${1-}" = --help ]; then
    sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"
    exit 0
fi
if [ $# -ne 1 ] || [[ $1 == -* ]]; then
    echo "usage: scripts/package.sh FOLDER, where the trees and zip files go" >&2
    exit 2
fi
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."

for library in fixedpoint engine firmware; do
    field() { sed -n "s/^$1=//p" $library/library.properties; }
    release=$(field name)-$(field version)
    rm -rf "${folder:?}/$release" "$folder/$release.zip"
    # The tests and the generators of tables stay with the project.
    git ls-files -z --cached --others --exclude-standard -- $library ":!$library/tests" \
        ":!$library/tables" ":!$library/lever.cpp" |
        while IFS= read -r -d '' path; do
            [ -e "$path" ] || continue
            mkdir -p "$(dirname "$folder/$release/${path#"$library"/}")"
            cp -p "$path" "$folder/$release/${path#"$library"/}"
        done
    # The CMakeLists.txt of the firmware builds the project's programs.
    [ $library != firmware ] || rm "$folder/$release/CMakeLists.txt"
    (cd "$folder" && python3 -m zipfile -c "$release.zip" "$release")
    echo "$folder/$release.zip"
done
