#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the pages of results/ as one PDF, to be cited: Markdown to HTML, and Chromium."""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import markdown

HERE = pathlib.Path(__file__).resolve().parent
PAGES = ("README.md", "choose_a_format.md", "engine.md", "stability.md", "lever.md")
STYLE = """
@page { size: A4; margin: 16mm 14mm; }
body { font: 10pt/1.4 sans-serif; }
h1 { break-before: page; } h1:first-of-type { break-before: avoid; } h1, h2, h3 { break-after: avoid; }
table { border-collapse: collapse; font-size: 6.5pt; margin: 1em 0; }
td, th { border: 0.5pt solid #999; padding: 1pt 3pt; text-align: left; overflow-wrap: break-word; }
img { max-width: 100%; max-height: 215mm; } tr, img { break-inside: avoid; }
code { font-size: 0.9em; }
"""


def html(results):
    """All pages as one, with the figures where they lie. Links among the pages lead into it."""
    parts = []
    for name in PAGES:
        text = (results / name).read_text(encoding="utf-8")
        for other in PAGES:
            text = text.replace(f"]({other}", f"](#{other}")
        parts.append(f'<a id="{name}"></a>' + markdown.markdown(text, extensions=["tables"]))
    return (f'<!doctype html><html lang="en"><meta charset="utf-8"><base href="{results.resolve().as_uri()}/">'
            f"<title>Fixed point on an 8-bit chip</title><style>{STYLE}</style>" + "".join(parts))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", required=True, type=pathlib.Path, help="the folder of the pages")
    parser.add_argument("--output", required=True, type=pathlib.Path, help="the PDF to write")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        page, printed = pathlib.Path(scratch) / "report.html", pathlib.Path(scratch) / "report.pdf"
        try:
            page.write_text(html(arguments.results), encoding="utf-8")
            done = subprocess.run(["chromium", "--headless", "--no-sandbox", "--disable-gpu",
                                   "--no-pdf-header-footer", f"--user-data-dir={scratch}/profile",
                                   f"--print-to-pdf={printed}", page.as_uri()],
                                  capture_output=True, text=True, timeout=300, check=False)
            if done.returncode != 0 or not printed.exists():
                raise OSError(f"chromium: {done.stderr.strip().splitlines()[-1:] or 'printed nothing'}")
            arguments.output.parent.mkdir(parents=True, exist_ok=True)
            partial = arguments.output.with_name(f".{arguments.output.name}.partial")
            partial.write_bytes(printed.read_bytes())
            partial.replace(arguments.output)
        except (OSError, subprocess.TimeoutExpired) as error:
            print("pdf: " + re.sub(r"\s+", " ", str(error)), file=sys.stderr)
            return 1
    print(arguments.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
