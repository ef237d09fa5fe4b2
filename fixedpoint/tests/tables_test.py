#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every generator of tables/ in a copy of the folder and compares what it writes, byte for
byte, with the files under src/. Every file there that says DO NOT EDIT must have been written.

Usage: tables_test.py [FILE], with a generator or a generated file: checks only what depends on
it."""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LIBRARY = Path(__file__).resolve().parent.parent


WRITER = re.compile(r"DO NOT EDIT(?:: written by (?:python3 )?fixedpoint/tables/(\w+\.py))?")


def generated_files():
    """The generated files, with the name of the generator that each states."""
    files = [path for path in (LIBRARY / "src").rglob("*") if path.is_file()]
    return {path.relative_to(LIBRARY): found[1] for path in files
            if (found := WRITER.search(path.read_text(encoding="utf-8")))}


def dependents(name):
    """The generators that import the given one, directly or indirectly, and itself."""
    found = {name}
    for path in (LIBRARY / "tables").glob("*.py"):
        if re.search(rf"^(import|from) {name[:-3]}\b", path.read_text(encoding="utf-8"), re.MULTILINE):
            found |= dependents(path.name)
    return found


def regenerate(copy, chosen):
    """Runs the chosen generators, which write to the folder next to their own. Returns those that
    fail."""
    shutil.copytree(LIBRARY / "tables", copy / "tables")
    for path in (LIBRARY / "src").rglob("*"):
        if path.is_dir():
            (copy / path.relative_to(LIBRARY)).mkdir(parents=True, exist_ok=True)
    table = Path("src/fixedpoint/kernel/table.hpp")  # of which kernels there are, for the C header
    shutil.copy(LIBRARY / table, copy / table)
    return [generator.relative_to(copy) for generator in sorted((copy / "tables").glob("*.py"))
            if generator.name in chosen
            and subprocess.run([sys.executable, generator], stdout=subprocess.DEVNULL).returncode]


def main():
    generated = generated_files()
    chosen = {path.name for path in (LIBRARY / "tables").glob("*.py")}
    if len(sys.argv) > 1:
        path = Path(sys.argv[1]).resolve().relative_to(LIBRARY)
        chosen = dependents(generated.get(path, path.name))
        generated = {path: writer for path, writer in generated.items() if writer in chosen}
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder)
        faults = [f"{generator}: fails" for generator in regenerate(copy, chosen)]
        written = {path.relative_to(copy) for path in (copy / "src").rglob("*") if path.is_file()}
        for path in sorted(written | generated.keys()):
            if path not in written:
                faults.append(f"{path}: no generator writes it")
            elif not (LIBRARY / path).is_file():
                faults.append(f"{path}: is missing")
            elif (LIBRARY / path).read_bytes() != (copy / path).read_bytes():
                faults.append(f"{path}: differs from what its generator writes")
    print("\n".join(faults) or f"{len(written)} files are as their generators write them.")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
