#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Links the device program that contains the subjects, and measures the footprint of each.

Every global function <operation>_<format>_<implementation> of the objects is a subject. An assembly
kernel fixedpoint_<operation>_<format>[_<variant>] replaces the C++ subject of that name (without a
variant: `default`), so that a call reaches it without a jump in between.

The footprint of a subject is the growth of a program that uses only this subject: flash (code,
tables, initialised data) and static RAM, including everything it pulls in. Code that operations
share counts once in a program that uses several: `nine_<format>_<implementation>` is the footprint of those of TOGETHER,
for ours from the default implementation if this one has no variant of its own, and
`own_<format>_<implementation>` that of all that this implementation has.
"""
import argparse
import concurrent.futures
import csv
import os
import re
import subprocess
import sys
import tempfile

FORMAT = r"(?:[qu]\d+_\d+|s\d+_\d+|float(?:64)?|int\d+)"
TOGETHER = ("add", "subtract", "multiply", "divide", "sqrt", "sin", "atan2", "exp", "log")
SUBJECT = re.compile(rf"^([a-z]\w*?)_({FORMAT})_([a-z_]+)$")
KERNEL = re.compile(rf"^fixedpoint_([a-z]\w*?)_({FORMAT})(?:_([a-z_]+))?$")


def run(command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}\n{done.stderr}")
    return done.stdout


def functions(objects):
    """The global functions that the objects define."""
    lines = run(["avr-nm", "--defined-only", "-g", *objects]).splitlines()
    return sorted({line.split()[2] for line in lines if re.match(r"^[0-9a-f]+ [TW] ", line)})


def subjects_of(objects):
    """The subjects that the objects define, and the kernel that replaces each."""
    names = functions(objects)
    subjects = sorted(name for name in names
                      if SUBJECT.match(name) and not name.startswith("fixedpoint_"))
    kernels = {}
    for name in names:
        kernel = KERNEL.match(name)
        if kernel:
            operation, number_format, variant = kernel.groups()
            kernels[f"{operation}_{number_format}_{variant or 'default'}"] = name
    # A kernel without a C++ subject of its name belongs to another program.
    return subjects, {name: kernel for name, kernel in kernels.items() if name in subjects}


def linked_as(subject, kernels):
    """The linker's options that keep a subject, its kernel under the subject's name."""
    if subject not in kernels:
        return [f"-Wl,-u,{subject}"]
    kernel = kernels[subject]
    return [f"-Wl,-u,{subject}", f"-Wl,-u,{kernel}", f"-Wl,--defsym={subject}={kernel}"]


def together(subjects):
    """The programs that use several subjects, by name."""
    kinds = {SUBJECT.match(name).groups()[1:] for name in subjects}
    programs = {}
    for number_format, implementation in sorted(kinds):
        own = [name for name in subjects
               if SUBJECT.match(name).groups()[1:] == (number_format, implementation)]
        # Not if the others are in another program.
        if not own[0].startswith(("abs_diff_", "acos_")) and implementation != "correctly_rounded":
            programs[f"own_{number_format}_{implementation}"] = own
        chosen = [f"{operation}_{number_format}_{implementation}" for operation in TOGETHER]
        if implementation != "published":
            chosen = [name if name in subjects else name.removesuffix(implementation) + "default"
                      for name in chosen]
        if set(chosen) <= set(subjects):
            programs[f"nine_{number_format}_{implementation}"] = chosen
    return programs


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", required=True, help="the ELF to write")
    parser.add_argument("--footprints", help="the CSV of footprints to write")
    parser.add_argument("--map", help="the map of the linker to write")
    parser.add_argument("objects", nargs="+")
    arguments = parser.parse_args()

    subjects, aliases = subjects_of(arguments.objects)

    def link(chosen, output, *further):
        options = [option for subject in chosen for option in linked_as(subject, aliases)]
        # The relocations show which tables a kernel reads.
        run(["avr-g++", "-mmcu=atmega328p", "-Os", "-Wl,--gc-sections,--emit-relocs", *options, *further,
             *arguments.objects, "-lm", "-o", output])

    def weigh(chosen, directory):
        handle, output = tempfile.mkstemp(suffix=".elf", dir=directory)
        os.close(handle)
        link(chosen, output)
        sizes = run(["avr-size", output]).splitlines()[1].split()
        os.unlink(output)
        text, data, bss = (int(size) for size in sizes[:3])
        return text + data, data + bss

    mapped = [f"-Wl,-Map={arguments.map}"] if arguments.map else []
    with tempfile.TemporaryDirectory() as directory:
        if arguments.footprints is None:
            link(subjects, arguments.output, *mapped)
            return
        empty_flash, empty_ram = weigh([], directory)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            programs = {subject: [subject] for subject in subjects} | together(subjects)
            weights = list(pool.map(lambda chosen: weigh(chosen, directory), programs.values()))
        partial = os.path.join(directory, "footprints.csv")
        with open(partial, "w", newline="", encoding="ascii") as stream:
            rows = csv.writer(stream, lineterminator="\n")
            rows.writerow(["subject", "flash_bytes", "ram_bytes"])
            for subject, (flash, ram) in zip(programs, weights):
                rows.writerow([subject, flash - empty_flash, ram - empty_ram])
        link(subjects, arguments.output + ".partial", *mapped)
        with open(partial, encoding="ascii") as stream, \
                open(arguments.footprints, "w", encoding="ascii") as target:
            target.write(stream.read())
    os.replace(arguments.output + ".partial", arguments.output)


if __name__ == "__main__":
    main()
