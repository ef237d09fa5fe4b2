#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Worlds at random of every feature, on the chip and on the host, for so many seconds: the tests
# RandomWorlds of the program world_test, with one seed after the other.
# Usage: random_worlds.sh WORLD_TEST SECONDS [FIRST_SEED]
# At a failure it says the call that shows it again, and exits with 1; with 2 for a wrong call.
set -euo pipefail

if [ $# -lt 2 ] || [ $# -gt 3 ] || ! [ -x "$1" ] || ! [[ "$2 ${3:-1}" =~ ^[1-9][0-9]*\ [1-9][0-9]*$ ]]; then
    echo "usage: random_worlds.sh WORLD_TEST SECONDS [FIRST_SEED], whole numbers above 0" >&2
    exit 2
fi
program=$1 seconds=$2 first=${3:-$(date +%s)}

for ((seed = first; SECONDS < seconds; ++seed)); do
    if ! RC_PARAMS="seed=$seed" "$program" --gtest_brief=1 '--gtest_filter=*RandomWorlds*'; then
        echo "random_worlds.sh: failed; again: RC_PARAMS=seed=$seed $program '--gtest_filter=*RandomWorlds*'" >&2
        exit 1
    fi
    echo "random_worlds.sh: seed $seed passed, $((SECONDS < seconds ? seconds - SECONDS : 0)) s left"
done
echo "random_worlds.sh: passed, $((seed - first)) seeds from $first on, $SECONDS s"
