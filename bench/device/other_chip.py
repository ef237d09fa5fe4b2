#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the subjects of one format for another chip than the ATmega328P: a program for each, since
a small chip cannot hold them all. Subjects that do not fit on their own are listed without a size.

Writes FOLDER/<subject>.elf, and FOLDER/programs.csv last: subject, and flash_bytes, the growth
of a program that uses only this subject.
"""
import argparse
import concurrent.futures
import csv
import os
import shutil
import subprocess
import sys
from pathlib import Path

import link_subjects

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
COMMON = ["-Os", "-std=gnu++14", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics",
          "-ffunction-sections", "-fdata-sections", "-fshort-enums"]
INCLUDES = f"-I{ROOT}/fixedpoint/src"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--mcu", required=True)
    parser.add_argument("--format", required=True)
    parser.add_argument("folder", type=Path)
    arguments = parser.parse_args()
    shutil.rmtree(arguments.folder, ignore_errors=True)
    arguments.folder.mkdir(parents=True)
    chip = f"-mmcu={arguments.mcu}"

    def compiled(source):
        target = str(arguments.folder / (source.name + ".o"))
        language = ["-x", "assembler-with-cpp", INCLUDES] if source.suffix == ".S" else [
            *COMMON, INCLUDES, f"-I{ROOT}", f"-DLIBRARY_FORMAT=FORMAT_{arguments.format}"]
        link_subjects.run(["avr-g++", chip, *language, "-c", str(source), "-o", target])
        return target

    def linked(subject, options):
        """The bytes of flash of the program; None if it does not fit."""
        target = str(arguments.folder / f"{subject}.elf")
        done = subprocess.run(
            ["avr-g++", chip, "-Os", "-Wl,--gc-sections",
             *options, *objects, "-lm", "-o", target],
            capture_output=True, text=True)
        if done.returncode != 0:
            if "will not fit in region" in done.stderr:
                return None
            sys.exit(f"{subject} for the {arguments.mcu}:\n{done.stderr}")
        text, data = link_subjects.run(["avr-size", target]).splitlines()[1].split()[:2]
        return int(text) + int(data)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        sources = [HERE / "subjects/library.cpp", HERE / "subjects/main.cpp",
                   *sorted((ROOT / "fixedpoint/src/fixedpoint/avr").glob("*.S"))]
        objects = list(pool.map(compiled, sources))
        subjects, kernels = link_subjects.subjects_of(objects)
        empty = linked("empty", [])
        sizes = list(pool.map(
            lambda subject: linked(subject, link_subjects.linked_as(subject, kernels)), subjects))
    for target in [*objects, arguments.folder / "empty.elf"]:
        os.unlink(target)
    partial = arguments.folder / "programs.partial"
    with partial.open("w", newline="", encoding="ascii") as stream:
        rows = csv.writer(stream, lineterminator="\n")
        rows.writerow(["subject", "flash_bytes"])
        rows.writerows((subject, "" if size is None else size - empty)
                       for subject, size in zip(subjects, sizes))
    partial.rename(arguments.folder / "programs.csv")


if __name__ == "__main__":
    main()
