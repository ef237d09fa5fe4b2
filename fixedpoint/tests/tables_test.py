#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every generator of tables/ in a copy of the folder and compares what it writes, byte for
byte, with the files under src/. Every file there that says DO NOT EDIT must have been written."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LIBRARY = Path(__file__).resolve().parent.parent


def generated_files():
    files = (path for path in (LIBRARY / "src").rglob("*") if path.is_file())
    return {path.relative_to(LIBRARY) for path in files if b"DO NOT EDIT" in path.read_bytes()}


def regenerate(copy):
    """Generators write below the folder beside their own. Returns those that fail."""
    shutil.copytree(LIBRARY / "tables", copy / "tables")
    for path in (LIBRARY / "src").rglob("*"):
        if path.is_dir():
            (copy / path.relative_to(LIBRARY)).mkdir(parents=True, exist_ok=True)
    table = Path("src/fixedpoint/kernel/table.hpp")  # of which kernels there are, for the C header
    shutil.copy(LIBRARY / table, copy / table)
    return [generator.relative_to(copy) for generator in sorted((copy / "tables").glob("*.py"))
            if subprocess.run([sys.executable, generator], stdout=subprocess.DEVNULL).returncode]


def main():
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder)
        faults = [f"{generator}: fails" for generator in regenerate(copy)]
        written = {path.relative_to(copy) for path in (copy / "src").rglob("*") if path.is_file()}
        for path in sorted(written | generated_files()):
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
