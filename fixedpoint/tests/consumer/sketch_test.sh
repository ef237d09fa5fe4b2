#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Examples compile as Arduino sketches for the Nano, with the kernels they use linked.
# Usage: [LIBRARIES=FOLDER] sketch_test.sh SCRATCH_FOLDER SKETCH.ino ...
# LIBRARIES holds the libraries where they are not those of the project. The programs are SCRATCH_FOLDER/NAME.elf.
set -euo pipefail
scratch=$1
root=$(cd "$(dirname "$0")/../../.." && pwd)
rm -rf "$scratch" && mkdir -p "$scratch/libraries" "$scratch/build"
if [ -z "${LIBRARIES:-}" ]; then
    LIBRARIES=$scratch/libraries
    for library in fixedpoint engine firmware; do ln -s "$root/$library" "$LIBRARIES/$library"; done
fi

# The core's own flags, and one macro for the core itself: its WString.cpp names DECIMAL_DIG, which
# the <float.h> of avr-gcc 5.4 has for C only, so that Debian's core compiles with no sketch at all.
# No library names it; the toolchain that Arduino brings (7.3) has it.
# Sketches of one name share what is built of the core and of the libraries.
compile() {
    local sketch=$1 name elf kernels
    name=$(basename "$sketch" .ino)
    # As the Arduino IDE demands.
    [ "$(basename "$(dirname "$sketch")")" = "$name" ] || { echo "FAILED: $sketch is not in a folder of its name"; exit 1; }
    rm -rf "$scratch/sketch" "$scratch/build/sketch"
    cp -r "$(dirname "$sketch")" "$scratch/sketch"
    mv "$scratch/sketch/$name.ino" "$scratch/sketch/sketch.ino"
    arduino-builder -compile -quiet -warnings more \
        -hardware /usr/share/arduino-builder -hardware /usr/share/arduino/hardware \
        -tools /usr/share/arduino-builder -prefs runtime.tools.avr-gcc.path=/usr \
        -prefs compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ \
        -libraries "$LIBRARIES" -fqbn arduino:avr:nano:cpu=atmega328 \
        -build-path "$scratch/build" "$scratch/sketch/sketch.ino" >"$scratch/log" 2>&1 || {
        cat "$scratch/log"
        exit 1
    }
    if grep -E 'libraries/[^:]*: warning' "$scratch/log"; then
        echo "FAILED: warnings in the libraries"
        exit 1
    fi
    elf=$scratch/$name.elf
    mv "$scratch/build/sketch.ino.elf" "$elf"
    kernels=$(avr-nm "$elf" | grep -oE ' T fixedpoint_[a-z0-9_]+' | sort | sed 's/.*fixedpoint_//' | paste -sd ' ')
    [ -n "$kernels" ] || {
        echo "FAILED: no kernel of fixedpoint in $elf"
        exit 1
    }
    # What a sketch does not use costs nothing: a vtable only where something is made Printable.
    if ! grep -q 'printable(' "$sketch" && avr-nm -C "$elf" | grep PrintableNumber; then
        echo "FAILED: PrintableNumber in a sketch that does not use it"
        exit 1
    fi
    avr-size -A "$elf" | awk -v name="$name" '/^\.(text|data|bss)/ { bytes[$1] = $2 }
        END { print name ": " bytes[".text"] + bytes[".data"] " bytes of flash, " bytes[".data"] + bytes[".bss"] " of RAM" }'
    echo "kernels: $kernels"
}
failures=0
for sketch in "${@:2}"; do
    (compile "$sketch") || failures=1
done
exit $failures
