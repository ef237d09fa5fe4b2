#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A project of its own gets a library in one of three ways, on the host and on the AVR, and prints
# the same on both.
# Usage: consumer_test.sh fixedpoint|engine|c add_subdirectory|fetch_content|find_package SCRATCH_FOLDER
set -euo pipefail
library=$1 way=$2 scratch=$3
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
rm -rf "$scratch" && mkdir -p "$scratch"
libraries=(fixedpoint)
[ "$library" != engine ] || libraries+=(engine)
program=$library.cpp language=CXX linked=$library::$library
[ "$library" != c ] || program=c.c language=C linked=fixedpoint::c

quietly() { "$@" >"$scratch/log" 2>&1 || { echo "FAILED: $*"; cat "$scratch/log"; exit 1; }; }

for target in host avr; do
    build=$scratch/$target
    options=(-G Ninja)
    [ $target = host ] || options+=(-DCMAKE_TOOLCHAIN_FILE="$root/scripts/cmake/avr_toolchain.cmake")
    origin=
    case $way in
        add_subdirectory) origin=$root ;;
        fetch_content)
            origin=file://$scratch/project.tar.gz
            tar czf "$scratch/project.tar.gz" -C "$root" CMakeLists.txt "${libraries[@]}"
            ;;
        find_package)
            # Each library by itself, without any of the project around it, and then not even that.
            options+=(-DCMAKE_PREFIX_PATH="$build-installed")
            for each in "${libraries[@]}"; do
                cp -r "$root/$each" "$scratch/source"
                quietly cmake -S "$scratch/source" -B "$build-library" "${options[@]}"
                quietly cmake --build "$build-library"
                quietly cmake --install "$build-library" --prefix "$build-installed"
                rm -rf "$scratch/source" "$build-library"
            done
            ;;
    esac
    options+=(-DWAY="$way" -DORIGIN="$origin" -DLIBRARIES="$(IFS=';' && echo "${libraries[*]}")"
              -DPROGRAM="$program" -DLANGUAGE="$language" -DTARGET="$linked")
    quietly cmake -S "$here" -B "$build" "${options[@]}"
    quietly cmake --build "$build"
done

"$scratch/host/consumer" >"$scratch/host.txt"
# The simulator's colours, and the dot that it prints for the end of a line.
timeout 60 simavr -m atmega328p -f 16000000 "$scratch/avr/consumer.elf" 2>&1 |
    sed -nE 's/\x1b\[[0-9;]*m//g; s/^([a-z]+ -?[0-9.]+)\.\r?$/\1/p' >"$scratch/avr.txt" ||
    { echo "FAILED: the AVR's program does not end"; exit 1; }
avr-nm "$scratch/avr/consumer.elf" >"$scratch/symbols"

failures=0
fail() { echo "FAILED: $*"; failures=1; }
printed() { [[ $(cat "$scratch/host.txt") =~ $1 ]] || fail "no '$1' in what the host has printed: $(cat "$scratch/host.txt")"; }
kernels() { grep -oE ' T fixedpoint_\w+' "$scratch/symbols" | sed 's/.* T fixedpoint_//'; }
diff "$scratch/host.txt" "$scratch/avr.txt" || fail "the AVR prints something else than the host"
case $library in
    fixedpoint)
        printed 'angle -0.4366271598'$ # atan2(-1.4, 3) = -0.43662715981...
        lines=16 expected="multiply_q4_4 multiply_q8_8 divide_q16_16 sqrt_q32_32 atan2_q16_16"
        ;;
    engine)
        printed 'x 0.56' # after four seconds, by the equation of the angle 0.5668
        lines=8 expected="project2_q16_16"
        ;;
    c)
        printed 'angle -0.43663'$ # atan2(-1.4, 3)
        lines=5 expected="multiply_q16_16 divide_q8_24 sqrt_q32_32 atan2_q16_16"
        ;;
esac
[ "$(wc -l <"$scratch/host.txt")" = "$lines" ] || fail "the host has printed: $(cat "$scratch/host.txt")"
for kernel in $expected; do
    kernels | grep -qx "$kernel" || fail "no kernel $kernel in the AVR's program, which has: $(kernels | paste -sd ' ')"
done
if kernels | grep -qx exp_q16_16; then fail "a kernel that nothing uses is in the program"; fi
[ $failures -eq 0 ] && echo "$library by $way: the same $lines lines on host and AVR"
exit $failures
