#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Where the time of a build goes: seconds by room, and the slowest steps, from Ninja's log; and the
lines of source of each room.

Usage: scripts/build_times.py [BUILD_FOLDER] [--slowest N]

Steps that the build no longer has are left out. Seconds are of one core, under whatever load the
machine had; a step of ccache counts with the time it took. Lines are those of C++, assembly, Python,
scripts and templates that git knows, without tests, examples and generated files.
"""
import argparse
import collections
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SOURCES = {".cpp", ".hpp", ".h", ".c", ".S", ".inc", ".py", ".sh", ".j2", ".js", ".css", ".in", ".ino", ".awk", ".cmake"}


def outputs_of(folder):
    """The present targets of the build; the log also contains former ones."""
    listed = subprocess.run(["ninja", "-C", folder, "-t", "targets", "all"], check=True,
                            capture_output=True, text=True)
    return {line.rpartition(": ")[0] for line in listed.stdout.splitlines()}


def steps_of(log):
    """The last run of each step: output -> seconds. A step of several outputs counts once."""
    seconds, seen = {}, set()
    present = outputs_of(log.parent)
    for line in reversed(log.read_text(encoding="utf-8").splitlines()):
        fields = line.split("\t")
        if len(fields) != 5:
            continue  # the first line, which contains the version
        begin, end, _, output, command = fields
        if output not in present or output in seen or (begin, end, command) in seen:
            continue
        seen |= {output, (begin, end, command)}
        seconds[output] = (int(end) - int(begin)) / 1000
    return seconds


def room_of(output, folder):
    """The source folder of a target; tests and programs for the chip are separate."""
    path = re.sub(rf"^{re.escape(str(folder.resolve()))}/", "", output)
    parts = path.split("/")
    depth = 3 if parts[0] == "bench" and len(parts) > 3 and parts[1] in ("chip", "lab", "experiments") else \
        2 if parts[0] == "bench" and len(parts) > 2 else 1
    room = "/".join(part for part in parts[:depth] if part != "CMakeFiles") if len(parts) > 1 else "."
    tests = "/tests/" in path or "_test" in path
    kind = "tests" if tests else "host" if "CMakeFiles" in path or "." not in parts[-1] else "chip"
    return room, kind


def lines_by_room():
    """Room -> lines of its files, but not of those of a room within it."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=False)
    lines = collections.Counter()
    for name in listed.stdout.splitlines():
        path = ROOT / name
        if path.suffix not in SOURCES or {"tests", "examples"} & set(Path(name).parts) or name.startswith("results/"):
            continue
        text = path.read_text(encoding="utf-8")
        if "DO NOT EDIT" not in text[:300]:
            lines[room_of(f"{ROOT}/{name}", ROOT)[0]] += text.count("\n")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default="build/release", type=Path)
    parser.add_argument("--slowest", type=int, default=15, metavar="N", help="number of slowest steps to name (default: 15)")
    arguments = parser.parse_args()
    log = arguments.folder / ".ninja_log"
    if not log.is_file():
        print(f"build_times.py: no {log}: nothing was built there", file=sys.stderr)
        return 2

    steps, lines = steps_of(log), lines_by_room()
    rooms = collections.defaultdict(lambda: collections.Counter())
    for output, seconds in steps.items():
        room, kind = room_of(output, arguments.folder)
        rooms[room][kind] += seconds
        rooms[room]["steps"] += 1
    print(f"{len(steps)} steps, {sum(steps.values()):.0f} s of one core, {lines.total()} lines of source\n")
    print(f"{'room':34}{'steps':>7}{'host, s':>9}{'chip, s':>9}{'tests, s':>9}{'lines':>8}")
    for room, row in sorted(rooms.items(), key=lambda item: -sum(item[1].values())):
        print(f"{room:34}{row['steps']:7}{row['host']:9.0f}{row['chip']:9.0f}{row['tests']:9.0f}{lines.pop(room, 0):8}")
    for room, count in sorted(lines.items()):
        print(f"{room:34}{'':34}{count:8}")
    print("\nslowest steps")
    for output, seconds in sorted(steps.items(), key=lambda item: -item[1])[:arguments.slowest]:
        print(f"{seconds:8.1f}  {output}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
