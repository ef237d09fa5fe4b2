#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A project of its own gets the libraries in one of three ways, on the host and on the AVR, and each
# of its programs prints the same on both.
# Usage: consumer_test.sh add_subdirectory|fetch_content|find_package SCRATCH_FOLDER
set -euo pipefail
way=$1 scratch=$2
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
rm -rf "$scratch" && mkdir -p "$scratch"

quietly() { "$@" >"$scratch/log" 2>&1 || { echo "FAILED: $*"; cat "$scratch/log"; exit 1; }; }

# project LIBRARIES PROGRAMS: the lists are CMake's.
project() {
    quietly cmake -S "$here" -B "$scratch/build" "${options[@]}" -DWAY="$way" -DORIGIN="$origin" -DLIBRARIES="$1" \
        -DPROGRAMS="$2" -DCMAKE_RUNTIME_OUTPUT_DIRECTORY="$scratch/$target"
    quietly cmake --build "$scratch/build"
    rm -rf "$scratch/build"
}

# installs LIBRARY: by itself, without any of the project around it.
installs() {
    cp -r "$root/$1" "$scratch/source"
    quietly cmake -S "$scratch/source" -B "$scratch/library" "${options[@]}"
    quietly cmake --build "$scratch/library"
    quietly cmake --install "$scratch/library" --prefix "$scratch/installed"
    rm -rf "$scratch/source" "$scratch/library"
}

for target in host avr; do
    options=(-G Ninja)
    [ $target = host ] || options+=(-DCMAKE_TOOLCHAIN_FILE="$root/scripts/cmake/avr_toolchain.cmake")
    origin=
    case $way in
        add_subdirectory) origin=$root ;;
        fetch_content)
            origin=file://$scratch/project.tar.gz
            tar czf "$scratch/project.tar.gz" -C "$root" CMakeLists.txt fixedpoint engine
            ;;
        find_package) options+=(-DCMAKE_PREFIX_PATH="$scratch/installed") ;;
    esac
    # The library's own project asks for C++, but once it is installed, one in C needs none.
    if [ "$way" = find_package ]; then
        installs fixedpoint
        project fixedpoint c
        project fixedpoint fixedpoint
        installs engine
        project "fixedpoint;engine" engine
        rm -rf "$scratch/installed"
    else
        project "fixedpoint;engine" "c;fixedpoint;engine"
    fi
done

failures=0
fail() { echo "FAILED: $program: $*"; failures=1; }
kernels() { grep -oE ' T fixedpoint_\w+' "$scratch/symbols" | sed 's/.* T fixedpoint_//'; }
# prints PROGRAM LINES TEXT KERNELS ...: what it prints, and which kernels are linked.
prints() {
    program=$1
    local lines=$2 text=$3
    "$scratch/host/$program" >"$scratch/host.txt"
    # The simulator's colours, and the dot that it prints for the end of a line.
    timeout 60 simavr -m atmega328p -f 16000000 "$scratch/avr/$program.elf" 2>&1 |
        sed -nE 's/\x1b\[[0-9;]*m//g; s/^([a-z]+ -?[0-9.]+)\.\r?$/\1/p' >"$scratch/avr.txt" ||
        fail "the AVR's program does not end"
    avr-nm "$scratch/avr/$program.elf" >"$scratch/symbols"
    diff "$scratch/host.txt" "$scratch/avr.txt" || fail "the AVR prints something else than the host"
    [[ $(cat "$scratch/host.txt") =~ $text ]] || fail "no '$text' in what the host has printed: $(cat "$scratch/host.txt")"
    [ "$(wc -l <"$scratch/host.txt")" = "$lines" ] || fail "the host has printed: $(cat "$scratch/host.txt")"
    for kernel in "${@:4}"; do
        kernels | grep -qx "$kernel" || fail "no kernel $kernel in the AVR's program, which has: $(kernels | paste -sd ' ')"
    done
    if kernels | grep -qx exp_q16_16; then fail "a kernel that nothing uses is in the program"; fi
}
# atan2(-1.4, 3) = -0.43662715981...
prints fixedpoint 16 'angle -0.4366271598'$ multiply_q4_4 multiply_q8_8 divide_q16_16 sqrt_q32_32 atan2_q16_16
prints c 5 'angle -0.43663'$ multiply_q16_16 divide_q8_24 sqrt_q32_32 atan2_q16_16
# After four seconds, by the equation of the angle, 0.5668.
prints engine 8 'x 0.56' project2_q16_16
[ $failures -eq 0 ] && echo "by $way, three programs print the same on host and AVR"
exit $failures
