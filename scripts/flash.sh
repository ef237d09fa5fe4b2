#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Writes a program to an Arduino Nano through its bootloader, reads it back, and names the files with
# the figures measured for this very program.
#
# Usage: scripts/flash.sh [--port PORT] [--old-bootloader] [ELF]
#   --port PORT        serial port of the board (default: the only board found)
#   --old-bootloader   57600 baud, for Nanos from before 2018; otherwise 115200 baud
#   ELF                the program (default: the lever, build/release/firmware/lever.elf)
#
# Exit status: 0 if the board holds the program, 2 for a wrong call or program, 3 for a port that is
# missing, ambiguous or in use, 4 for a board that does not answer or is not a Nano, 5 if the flash
# does not hold what was written, 6 for a missing tool.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
devices=${FLASH_DEVICES:-/dev} # the tests have devices of their own

die() {
    echo "flash.sh: $2" >&2
    exit "$1"
}

port=
baud=115200
limit=$((0x7E00)) # the bootloader begins here
elf=
while [ $# -gt 0 ]; do
    case $1 in
        --help) sed -n '3,/^set /{/^set /d;s/^# \{0,1\}//p}' "$0"; exit 0 ;;
        --port) [ $# -gt 1 ] && [ -n "$2" ] || die 2 "--port needs the name of a serial port"; port=$2; shift ;;
        --old-bootloader) baud=57600 limit=$((0x7800)) ;;
        -*) die 2 "unknown option '$1'; see --help" ;;
        *) [ -z "$elf" ] || die 2 "one program at a time, not both '$elf' and '$1'"; elf=$1 ;;
    esac
    shift
done

for tool in avrdude avr-objcopy avr-readelf sha256sum; do
    command -v $tool >/dev/null || die 6 "$tool is missing; scripts/setup.sh installs it"
done

# The program.
if [ -z "$elf" ]; then
    elf=$root/build/release/firmware/lever.elf
    [ -f "$elf" ] || die 2 "no build/release/firmware/lever.elf; scripts/build.sh builds it"
fi
[ -f "$elf" ] || die 2 "no program '$elf'"
header=$(LC_ALL=C avr-readelf -h "$elf" 2>/dev/null || true)
[[ $header =~ Machine:\ +Atmel\ AVR && $header =~ Type:\ +EXEC ]] || die 2 "'$elf' is not a linked program for the AVR"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
image=$scratch/image.bin
# What is measured and hashed everywhere in this project, and no more, is what goes to the board.
avr-objcopy -O binary -j .text -j .data "$elf" "$image" 2>"$scratch/log" ||
    die 2 "'$elf' cannot be made into a flash image: $(head -1 "$scratch/log")"
size=$(stat -c %s "$image")
[ "$size" -gt 0 ] || die 2 "'$elf' has nothing to put into the flash"
[ "$size" -le $limit ] || die 2 "'$elf' takes $size bytes of flash; the bootloader leaves $limit"
hash=$(sha256sum "$image" | cut -d' ' -f1)

# The port.
if [ -z "$port" ]; then
    declare -A boards=() # by the device that a name stands for
    for candidate in "$devices"/ttyUSB* "$devices"/ttyACM* "$devices"/serial/by-id/*; do
        [ -e "$candidate" ] && boards[$(readlink -f "$candidate")]=$candidate
    done
    [ ${#boards[@]} -gt 0 ] ||
        die 3 "no board: no $devices/ttyUSB* and no $devices/ttyACM*; plug it in, with a cable that carries data, or name its --port"
    [ ${#boards[@]} -eq 1 ] ||
        die 3 "several boards; choose one with --port: $(printf '%s\n' "${boards[@]}" | sort | paste -sd ' ')"
    port=${boards[*]}
fi
[ -e "$port" ] || die 3 "no port $port"
[ -c "$port" ] || die 3 "$port is not a serial port"
[ -r "$port" ] && [ -w "$port" ] || die 3 "no permission for $port; its group is $(stat -Lc %G "$port"): sudo usermod -aG $(stat -Lc %G "$port") $(id -un), then log in again"
# Linux lets two programs share a serial port, and each then gets half of the bytes.
user=$(find /proc/[0-9]*/fd -lname "$(readlink -f "$port")" 2>/dev/null | head -1 | cut -d/ -f3 || true)
[ -z "$user" ] || die 3 "$port is in use by $(cat "/proc/$user/comm" 2>/dev/null || echo process), process $user; close it first"

echo "flash.sh: writing $size bytes to $port at $baud baud" >&2
status=0
# The bootloader erases page by page as it writes and cannot erase the whole flash (-D).
avrdude -q -c arduino -p m328p -P "$port" -b $baud -x attempts=3 -D -U "flash:w:$image:r" >"$scratch/log" 2>&1 || status=$?
said() { grep -qiE "$1" "$scratch/log"; }
words() { grep -ioE "$1" "$scratch/log" | grep -v TIOCM | head -1; } # modem lines are not everywhere
if [ $status -ne 0 ]; then
    other=--old-bootloader
    [ $baud = 57600 ] && other="without --old-bootloader"
    if said 'expected signature|invalid device signature'; then
        die 4 "wrong board on $port: $(words 'signature = .*'); an ATmega328P has 0x1e950f"
    elif said 'verification mismatch'; then
        die 5 "the flash does not hold what was written: $(words 'device 0x.*')"
    elif said 'not in sync|not responding'; then
        die 4 "no answer from the board on $port at $baud baud; try $other"
    elif said 'unable to open programmer'; then
        die 3 "$port cannot be opened: $(words '(cannot|unable to open) .*')"
    fi
    die 5 "avrdude failed: $(words '(error|OS error).*')"
fi
said 'bytes of flash verified' || die 5 "avrdude has not verified the flash"

echo "flashed and verified: ${elf#"$root"/}, $size bytes"
echo "sha256 $hash"
figures=$(cd "$root" && grep -rlF --include='*.csv' --include='*.json' "$hash" results | sort | paste -sd ' ' || true)
workload=$root/results/data/workload.csv
if [ -n "$figures" ]; then
    echo "measured figures of this program: $figures"
elif [ -f "$workload" ] && others=$(grep -oE '\<[0-9a-f]{64}\>' "$workload" | sort -u | paste -sd ' ') && [ -n "$others" ]; then
    echo "no measured figures of this program: results/data/workload.csv is about $others"
else
    echo "no measured figures of this program in results/"
fi
