#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every command and program of every README works: commands are run, programs compiled for host and
chip, links and anchors followed. A command that is neither cheap nor has a substitute fails.

Usage: readme_test.py FIXBENCH SCRATCH_FOLDER"""

import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STARTS = re.compile(r"(?:build/release/bench/)?fixbench\s|scripts/\S+|bench/run_all\.sh|ctest\s|cmake\s|"
                    r"ninja\s|avr-\S+\s|python3\s|/usr/bin/python3\s|git\s")

# Commands that are run unchanged, in the root of the project: pattern, and why they are cheap.
RUN = [
    (r"fixbench --help", "prints"),
    (r"avr-g\+\+ .* program\.cpp .*", "compiles the first program of the page"),
]
# What is run instead of a command, and why.
INSTEAD = [
    (r"bench/run_all\.sh.*", "bench/run_all.sh --help", "measures for half an hour"),
    (r"scripts/test\.sh.*", "scripts/test.sh --help", "would run this test again"),
    (r"scripts/pdf\.sh.*", "scripts/pdf.sh --help", "installs packages"),
    (r"scripts/docs\.sh.*", "scripts/docs.sh --help", "the test scripts/docs runs it"),
    (r"scripts/package\.sh.*", "scripts/package.sh --help", "the test fixedpoint/package runs it"),
    (r"fixbench advise --scene .*", "fixbench advise --help", "the test bench/command_line runs it"),
    (r"scripts/setup\.sh.*", "bash -n scripts/setup.sh", "installs packages"),
    (r"scripts/flash\.sh.*", "bash -n scripts/flash.sh", "needs a board"),
    (r"fixbench(?: (?!-)[a-z_-]+)?.*", "fixbench {1} --help", "measures, or takes a file of the user's"),
    (r"ctest .*", "ctest --version", "runs the tests that this is one of"),
    (r"cmake .*", "cmake --version", "builds; the consumer's test does so"),
    (r"ninja .*", "ninja --version", "builds"),
    (r"scripts/build\.sh.*", "bash -n scripts/build.sh", "builds"),
    (r"scripts/mutation_test\.py.*", "/usr/bin/python3 scripts/mutation_test.py --help", "builds"),
    (r"scripts/lint\.sh.*", "scripts/lint.sh --help", "a test of its own"),
    (r"(g\+\+|avr-gcc|avr-g\+\+) .*fixedpoint_c\..*", "true", "the test fixedpoint/c_interface runs it"),
    (r"avr-gdb .*", "true", "an interactive program that the set-up does not install"),
    (r"avr-objdump .*", "avr-objdump --version", "takes a program of the user's"),
]
FLASH = 30720  # bytes that the bootloader leaves free

failures = []


def fail(place, what):
    failures.append(f"{place}: {what}")


def readmes():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "*.md"], capture_output=True, text=True)
    paths = listed.stdout.splitlines() if listed.returncode == 0 else [
        path.relative_to(ROOT) for path in ROOT.rglob("*.md") if "build" not in path.parts]
    return [ROOT / path for path in paths]


def fences(text):
    """Language, first line and content of each fenced block."""
    for block in re.finditer(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        yield block.group(1), text[:block.start()].count("\n") + 2, block.group(2)


def without_fences(text):
    return re.sub(r"^```\w*\n.*?^```$", lambda block: "\n" * block.group().count("\n"), text,
                  flags=re.MULTILINE | re.DOTALL)


def commands(text):
    """Line and text of each command: the lines of the blocks without a language, and the texts in backquotes that start
    like a command."""
    for language, line, block in fences(text):
        if language in ("", "sh", "bash"):
            for command in block.replace("\\\n", " ").splitlines():
                command = re.sub(r"\s+#.*", "", command).strip()
                if command:
                    yield line, " ".join(command.split())
    plain = without_fences(text)
    for quoted in re.finditer(r"`([^`]+)`", plain):
        command = " ".join(quoted.group(1).split())
        # A path by itself names a file, and `fixbench` the program.
        if STARTS.match(command + " ") and not command.endswith(("/", ".py", ".hpp", ".cpp", ".cmake", ".txt")) \
                and command != "fixbench":
            yield plain[:quoted.start()].count("\n") + 1, command


def run(command, folder=ROOT):
    return subprocess.run(command, shell=True, cwd=folder, capture_output=True, text=True, timeout=120)


def check_command(place, command, fixbench, scratch):
    command = command.replace("build/release/bench/fixbench", "fixbench")
    for pattern, _ in RUN:
        if re.fullmatch(pattern, command):
            break
    else:
        for pattern, substitute, _ in INSTEAD:
            if re.fullmatch(pattern, command):
                words = command.split()
                name = words[1] if len(words) > 1 and not words[1].startswith("-") else ""
                command = substitute.replace("{1}", name)
                break
        else:
            fail(place, f"`{command}` is neither run nor has a substitute: add it to {Path(__file__).name}")
            return
    command = re.sub(r"^fixbench", str(fixbench), command)
    command = command.replace("program.cpp", str(scratch / "program.cpp"))
    command = command.replace("program.elf", str(scratch / "program.elf"))
    done = run(command)
    if done.returncode != 0:
        fail(place, f"`{command}` fails: {(done.stderr or done.stdout).strip()[-300:]}")
    elif "program.elf" in command:
        sizes = run(f"avr-size {scratch / 'program.elf'}").stdout.splitlines()[1].split()
        if int(sizes[0]) + int(sizes[1]) > FLASH:
            fail(place, f"the program takes {sizes[0]} bytes of flash, more than {FLASH}")


def check_program(place, program, scratch):
    """Compiles the program for host and chip; a program without main() gets one."""
    if not re.search(r"\bmain\(", program):
        program += "\nint main() {}\n"
    path = scratch / "program.cpp"
    path.write_text(program, encoding="utf-8")
    include = f"-I {ROOT}/fixedpoint/src -I {ROOT}/engine/src -I {ROOT}/firmware/src"
    for compiler in ("g++ -std=c++17", "avr-g++ -mmcu=atmega328p -std=gnu++14"):
        done = run(f"{compiler} -Wall -Wextra -Werror -Wno-unused -fsyntax-only {include} {path}")
        if done.returncode != 0:
            fail(place, f"{compiler} refuses the program: {done.stderr.strip()[:300]}")


def anchors(path):
    """The anchors of the headings, as GitHub makes them, and of elements with a name."""
    text = without_fences(path.read_text(encoding="utf-8"))
    found = set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", text))
    for heading in re.findall(r"^#+ +(.*)$", text, re.MULTILINE):
        plain = re.sub(r"[`*]|\[([^\]]*)\]\([^)]*\)", r"\1", heading).strip().lower()
        found.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return found


def check_links(readme, text):
    plain = without_fences(text)
    for link in re.finditer(r"\]\(([^)\s]+)\)", plain):
        target, _, anchor = link.group(1).partition("#")
        place = f"{readme.relative_to(ROOT)}:{plain[:link.start()].count(chr(10)) + 1}"
        if re.match(r"[a-z]+:", target):
            continue
        path = (readme.parent / target).resolve() if target else readme
        if not path.exists():
            fail(place, f"{target} does not exist")
        elif anchor and path.suffix == ".md" and anchor not in anchors(path):
            fail(place, f"{target} has no section #{anchor}")


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    fixbench, scratch = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    count = 0
    for readme in readmes():
        text = readme.read_text(encoding="utf-8")
        check_links(readme, text)
        if readme.is_relative_to(ROOT / "results"):
            continue  # pages: the commands that they name have made them
        programs = [(line, block) for language, line, block in fences(text) if language == "cpp"]
        for line, program in programs:
            check_program(f"{readme.relative_to(ROOT)}:{line}", program, scratch)
        if programs:  # the one that a manual build on the page is about
            first = programs[0][1]
            (scratch / "program.cpp").write_text(
                first if "main(" in first else first + "\nint main() { return finer.raw() != 0; }\n",
                encoding="utf-8")
        for line, command in commands(text):
            check_command(f"{readme.relative_to(ROOT)}:{line}", command, fixbench, scratch)
            count += 1
    for failure in failures:
        print(failure)
    print(f"{count} commands, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
