#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The API reference has every public name, and one without documentation is noticed.
# Usage: docs_test.sh SCRATCH_FOLDER
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$1
rm -rf "$scratch" && mkdir -p "$scratch/scripts"
failures=0
fail() { echo "FAILED: $*"; failures=1; }

"$root/scripts/docs.sh" "$scratch/reference" || exit 1
# One name of each kind and library.
for name in q16_16_multiply_add Q8_24_RATIO multiply_add from_decimal_checked TextStatus division_by_zero \
    add_anchored_rope ImplicitSprings restitution_threshold no_such_link \
    servo_longest try_write FIRMWARE_INTERRUPTS ticks_per_millisecond; do
    grep -rqw --include='*.html' "$name" "$scratch/reference/html" || fail "the reference has no $name"
done
for name in multiply_full DepthInterpolation RoundsOnce fixedpoint_multiply_q16_16 FIXEDPOINT_REPORTED_OPERATIONS; do
    if grep -rqw --include='*.html' "$name" "$scratch/reference/html"; then fail "the reference has $name, which is internal"; fi
done

# Without its comment, a function of each library is an error that names it.
cp -r "$root/scripts/docs.sh" "$root/scripts/Doxyfile" "$scratch/scripts"
for library in fixedpoint engine firmware; do
    mkdir -p "$scratch/$library" && cp -r "$root/$library/src" "$scratch/$library"
done
undocument() {  # FILE COMMENT NAME
    sed -i "s|///* *$2|// $2|" "$scratch/$1"
    if "$scratch/scripts/docs.sh" >"$scratch/log" 2>&1; then fail "nobody misses '$2' in $1"; fi
    grep -q "$3" "$scratch/log" || fail "no word of $3: $(cat "$scratch/log")"
    cp "$root/$1" "$scratch/$1"
}
undocument fixedpoint/src/fixedpoint/math.hpp 'The smaller of the two' 'min('
undocument fixedpoint/src/fixedpoint_c.h 'The number 1.' Q4_4_ONE
undocument engine/src/engine/world.hpp "Multiplies each velocity by its particle's" 'damp()'
undocument firmware/src/firmware/renderer.hpp 'Sends the next frame completely' 'refresh()'

[ $failures -eq 0 ] && echo "every public name is documented"
exit $failures
