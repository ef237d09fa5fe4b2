#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each recipe of CONTRIBUTING.md that has an example, "**A function**, such as `tanh`: 9 files", lists as many
files as it says. Each exists, and has the example in it or in its name."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RECIPE = re.compile(r"^\*\*([^*]+)\*\*, such as `(\w+)`[^:]*: (\d+)(?: more)? files(?:.*\n)+?\n((?:- .*\n(?:  .*\n)*)+)",
                    re.MULTILINE)


def spellings(example):
    """An example as a name, as a type, and, for a format, as its bits."""
    bits = re.fullmatch(r"q(\d+)_(\d+)", example)
    return [example, example.replace("_", ""), *([f"{bits[1]}, {bits[2]}"] if bits else [])]


def faults(text):
    recipes = RECIPE.findall(text)
    found = [] if len(recipes) == text.count(", such as `") else ["a recipe with an example is not read"]
    for name, example, count, items in recipes:
        paths = re.findall(r"^- `([^`]+)`: ", items, re.MULTILINE)
        if len(paths) != int(count):
            found.append(f"{name}: {count} files, but {len(paths)} are listed")
        for path in paths:
            if not (ROOT / path).is_file():
                found.append(f"{name}: there is no {path}")
            elif not any(each in (path + (ROOT / path).read_text(encoding="utf-8")).lower()
                         for each in spellings(example)):
                found.append(f"{name}: {path} has no {example}")
    return found


def main():
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    found = faults(text)
    # The test itself: a wrong number and a wrong name are noticed.
    for wrong in (text.replace(": 9 files", ": 8 files"), text.replace("such as `tanh`", "such as `tang`")):
        if not faults(wrong):
            found.append("a wrong recipe is not noticed")
    print("\n".join(found) or "The recipes are as they say.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
