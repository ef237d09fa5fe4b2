#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Rooms include only what lies below them: fixedpoint <- engine <- firmware, and in the bench
# chip <- lab <- experiments. Tests in a room may use the oracle of reference/ and, where they run on
# the simulated chip, the bench. Usage: rooms_test.sh SOURCE_FOLDER
set -u
cd "$1" || exit 1
failures=0

# Includes of a folder, as FILE:LINE:#include "PATH, but for those of its tests where `tests` is given.
includes() {
    grep -rnoE '^[[:space:]]*#[[:space:]]*include[[:space:]]*["<][^">]+' "$1" \
        --include='*.?pp' --include='*.h' --include='*.c' --include='*.S' --include='*.ino' |
        { if [ "${2:-}" = tests ]; then grep -v '^[^:]*/tests/'; else cat; fi; }
}

# forbid FOLDER PATHS [tests]: no include of FOLDER matches the pattern PATHS.
forbid() {
    local found
    found=$(includes "$1" "${3:-}" | grep -E "[\"<]($2)")
    [ -n "$(includes "$1" "${3:-}")" ] || found="$1: no includes found: the folder has moved"
    [ -z "$found" ] && return
    echo "$1 may not include $2:"
    echo "$found"
    failures=$((failures + 1))
}

forbid fixedpoint 'engine[./]|firmware/|bench/|reference/' tests
forbid engine 'firmware/|bench/|reference/' tests
forbid firmware 'bench/|reference/' tests
forbid reference 'fixedpoint[./]|engine[./]|firmware/|bench/' tests
forbid bench/chip 'fixedpoint[./]|engine[./]|firmware/|reference/|bench/(lab|experiments|live|device)/'
forbid bench/lab 'engine[./]|firmware/|bench/(experiments|live)/'
forbid bench/experiments 'bench/live/'
grep -rn --include=CMakeLists.txt -E 'target_link_libraries\([^)]*(records|operands|lab_subjects|reference)\b' bench/chip &&
    failures=$((failures + 1))
# libelf has one user.
users=$(grep -rlE '#include <(gelf|libelf)\.h>' bench firmware engine fixedpoint reference)
[ "$users" = bench/chip/simulator/elf.cpp ] || { echo "libelf is used by: $users" && failures=$((failures + 1)); }
exit $((failures != 0))
