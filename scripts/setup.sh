#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs what the project needs to build and run, from Debian's packages. Returns quickly if
# everything is there.
#
# Usage: scripts/setup.sh [--tests | --fuzz | --pdf] [--list]
#   --tests  also installs what the tests need
#   --fuzz   also installs what fuzzing needs
#   --pdf    also installs what printing the report needs
#   --list   prints the packages and installs nothing
set -euo pipefail

packages=(
    g++ cmake ninja-build git ca-certificates
    gcc-avr binutils-avr avr-libc arduino-core-avr arduino-builder avrdude libsimavr-dev simavr
    libelf-dev libssl-dev libncurses-dev
    libgsl-dev libboost-dev libgmp-dev libmpfr-dev libbox2d-dev
    libbenchmark-dev libgtest-dev libgmock-dev librapidcheck-dev
    libcli11-dev nlohmann-json3-dev libfmt-dev
    python3 python3-matplotlib python3-jinja2 python3-tqdm python3-z3 python3-jsonschema
    nodejs npm
)
for_tests=(clang-format clang-19 clang-tidy-19 libclang-rt-19-dev libc++-19-dev shellcheck python3-pyflakes python3-numpy python3-mpmath
    chromium gdb doxygen parallel)
for_fuzzing=(clang-19 libclang-rt-19-dev)
for_printing=(chromium python3-markdown)

list=
for argument in "$@"; do
    case $argument in
        --tests) packages+=("${for_tests[@]}") ;;
        --fuzz) packages+=("${for_fuzzing[@]}") ;;
        --pdf) packages+=("${for_printing[@]}") ;;
        --list) list=yes ;;
        *) echo "setup.sh: unknown argument '$argument'; the options are --tests, --fuzz, --pdf and --list" >&2; exit 2 ;;
    esac
done
if [ -n "$list" ]; then
    printf '%s\n' "${packages[@]}"
    exit 0
fi

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "setup.sh: this is not a Debian system. Install the equivalents of these packages:" >&2
    printf '  %s\n' "${packages[@]}" >&2
    # What a build needs most. If it is there, go on and let CMake name anything else.
    for tool in g++ cmake ninja avr-gcc avr-objdump python3 node; do
        command -v "$tool" >/dev/null || { echo "setup.sh: missing: $tool" >&2; exit 1; }
    done
    exit 0
fi

missing=()
for package in "${packages[@]}"; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] && continue
    # Node.js may come from elsewhere than Debian, and then brings npm with it.
    case $package in nodejs) command -v node >/dev/null && continue ;; npm) command -v npm >/dev/null && continue ;; esac
    missing+=("$package")
done
[ ${#missing[@]} -eq 0 ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
        echo "setup.sh: neither root nor sudo here. As root: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
echo "setup.sh: installing ${missing[*]}" >&2
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -qq >&2
"${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
