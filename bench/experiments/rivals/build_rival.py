#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the programs of a rival from a user's checkout: an ELF file and the footprints of its subjects for each variant.

Usage: build_rival.py RIVAL [--source FOLDER] --output FOLDER. Prints JSON: version, commit, and the programs by
variant. A failure is one line on stderr.
"""
import argparse
import glob
import json
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
DEVICE = os.path.join(ROOT, "bench", "device")
OPTIONS = ["-mmcu=atmega328p", "-DF_CPU=16000000UL", "-Os", "-ffunction-sections", "-fdata-sections", "-w"]
BY_ENDING = {
    ".c": ["avr-gcc", "-std=gnu11"],
    ".cpp": ["avr-g++", "-std=gnu++14", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"],
    ".S": ["avr-gcc", "-x", "assembler-with-cpp"],
}


def fail(text):
    sys.exit(" ".join(text.split()))


def run(command, **options):
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    except OSError as error:
        fail(f"{command[0]}: {error.strerror}")
    if done.returncode != 0:
        lines = done.stderr.splitlines()
        errors = [line for line in lines if "undefined reference" in line or "rror:" in line] or lines or [""]
        fail(f"{os.path.basename(command[0])} fails for {command[-1]}: {errors[0]}")
    return done.stdout.strip()


def commit_of(source):
    """Empty if the checkout is not in git, or only part of another repository."""
    git = ["git", "-C", source]
    top = subprocess.run([*git, "rev-parse", "--show-toplevel"], capture_output=True, text=True, check=False)
    if top.returncode != 0 or os.path.realpath(top.stdout.strip()) != os.path.realpath(source):
        return ""
    return run([*git, "rev-parse", "--short=12", "HEAD"])


def version_of(rival, source):
    if source is None:
        return run(["avr-gcc", "-dumpversion"])
    if "version" in rival:
        name, pattern = rival["version"]
        with open(os.path.join(source, name), encoding="utf-8", errors="replace") as stream:
            found = re.search(pattern, stream.read(), re.MULTILINE)
        if found:
            return ".".join(group.strip() for group in found.groups())
    return ""


def found(pattern):
    """The files that match; if none does, the pattern itself, which is then reported missing."""
    return sorted(glob.glob(pattern)) or [pattern]


def build(rival, variant, options, source, folder):
    below = [os.path.join(source, name) for name in rival.get("include", [])]
    includes = [f"-I{name}" for name in [*below, os.path.join(HERE, "adapters"), ROOT]]
    files = [os.path.join(HERE, "adapters", rival["adapter"]), os.path.join(DEVICE, "subjects", "main.cpp"),
             *(name for pattern in rival.get("sources", []) for name in found(os.path.join(source, pattern)))]
    for name in [*below, *files]:
        if not os.path.exists(name):
            fail(f"{source} is not a checkout of {rival['origin']}: {os.path.relpath(name, source)} is missing")
    os.makedirs(os.path.join(folder, variant), exist_ok=True)
    objects = []
    for number, name in enumerate(files):
        objects.append(os.path.join(folder, variant, f"{number}_{os.path.basename(name)}.o"))
        compiler = BY_ENDING[os.path.splitext(name)[1]]
        run([*compiler, *OPTIONS, *includes, f"-DRIVAL={variant}", *options, "-c", "-o", objects[-1], name])
    program = os.path.join(folder, variant + ".elf")
    run([sys.executable, os.path.join(DEVICE, "link_subjects.py"), "--output", program, "--footprints",
         os.path.join(folder, variant + ".footprints.csv"), *objects])
    return program


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rival")
    parser.add_argument("--source")
    parser.add_argument("--output", required=True)
    arguments = parser.parse_args()
    with open(os.path.join(HERE, "rivals.json"), encoding="ascii") as stream:
        rival = json.load(stream)[arguments.rival]
    source = arguments.source
    programs = {variant: build(rival, variant, options, source or HERE, arguments.output)
                for variant, options in rival["variants"].items()}
    json.dump({"version": version_of(rival, source), "commit": commit_of(source) if source else "",
               "programs": programs}, sys.stdout)


if __name__ == "__main__":
    main()
