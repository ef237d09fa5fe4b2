#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures and writes the pages of results/ from its data files."""
import argparse
import concurrent.futures
import contextlib
import csv
import datetime
import filecmp
import json
import multiprocessing
import pathlib
import re
import subprocess
import sys
import tempfile
import traceback

import jinja2
import tqdm

import blocks
import bounds
import choose_a_format
import division_cycles
import error_against_cycles
import error_histograms
import explorer
import features
import growth
import haptic_region
import haptic_timing
import headline
import identification
import lever
import operations
import replay
import rivals
import scenes
import scenes_workload
import stability
import style
import table_3_2
from data import Data, DataError, listed, nearest

HERE = pathlib.Path(__file__).resolve().parent

# The page that a template becomes, where the data file that it is about is there.
PAGES = {
    "results.md.j2": ("README.md", "operations"),
    "choose_a_format.md.j2": ("choose_a_format.md", "operations"),
    "engine.md.j2": ("engine.md", "scenes"),
    "stability.md.j2": ("stability.md", "stability"),
    "lever.md.j2": ("lever.md", "haptic"),
}


def figures(data):
    """The name and the function of each figure."""
    makers = {
        "headline": lambda: headline.draw(data),
        "table_3_2": lambda: table_3_2.draw(data),
        "division_cycles": lambda: division_cycles.draw(data),
        "error_against_cycles_32": lambda: error_against_cycles.draw(data),
        "error_histograms": lambda: error_histograms.draw(data),
    }
    if data.has("scenes"):
        makers["scenes"] = lambda: scenes.draw(data)
        makers["scenes_time_steps"] = lambda: scenes.draw_time_steps(data)
    if data.has("growth"):
        makers["growth"] = lambda: growth.draw(data)
    if data.has("stability"):
        makers["stability_stiffness"] = lambda: stability.draw_stiffness(data)
        makers["stability_speed"] = lambda: stability.draw_speed(data)
    if data.has("haptic_pins"):
        makers["haptic_timing"] = lambda: haptic_timing.draw(data)
    if data.has("stable_region"):
        makers["haptic_region"] = lambda: haptic_region.draw(data)
        makers["haptic_oscillation"] = lambda: haptic_region.draw_oscillation(data)
    if data.has("workload"):
        makers["scenes_workload_trace"] = lambda: scenes_workload.draw_trace(data)
        makers["scenes_workload_rounds"] = lambda: scenes_workload.draw_rounds(data)
    return makers


def version(*command):
    """The last word of the first line that the command prints."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "not found"
    return done.stdout.splitlines()[0].split()[-1]


def tool_versions():
    def package(name):
        return version("dpkg-query", "-W", "-f=${Version}", name)
    return {
        "avr-gcc": version("avr-gcc", "--version"),
        "avr-libc": package("avr-libc"),
        "simavr": package("libsimavr-dev"),
        "Arduino core": package("arduino-core-avr"),
        "g++": version("g++", "--version"),
        "GSL": package("libgsl-dev"),
        "MPFR": package("libmpfr-dev"),
        "matplotlib": package("python3-matplotlib"),
    }


def note_tools(data):
    """Writes tools.json: the tools with which the data of the folder were measured, and when."""
    write_whole(data / "tools.json", json.dumps(
        {"date": datetime.date.today().isoformat(), "tools": tool_versions()}, indent=1) + "\n")


def cell(value):
    """A cell of a Markdown table."""
    if value is None:
        return "–"
    if isinstance(value, float):
        return f"{value:.4g}" if abs(value) < 1000 else f"{value:.0f}"
    return str(value).replace("|", "\\|")


def write_whole(path, text):
    partial = path.parent / f".{path.name}.partial"
    partial.write_text(text, encoding="utf-8")
    partial.replace(path)


def no_gap(value):
    """A value as it is printed on a page. A missing value is an error: None would hide a finding."""
    if value is None:
        raise DataError("a value is missing")
    return value


def templates():
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), trim_blocks=True,
                                     lstrip_blocks=True, keep_trailing_newline=True,
                                     undefined=jinja2.StrictUndefined, finalize=no_gap)
    environment.filters["cell"] = cell
    return environment


def page(environment, template, names):
    """The text of a page."""
    text = environment.get_template(template).render(names)
    gap = re.search(r"^.*\b(?:None|nan|NaN)\b.*$", text, re.MULTILINE)
    if gap:
        raise DataError(f"a value is missing in '{gap.group().strip()}'")
    return text


@contextlib.contextmanager
def telling(what):
    """Turns any failure over impossible data into a DataError that says what was to be made of them."""
    try:
        yield
    except (DataError, jinja2.TemplateError, ArithmeticError, LookupError, StopIteration, TypeError,
            ValueError) as error:
        # The innermost line of a template, if there is one.
        lines = [f"{pathlib.Path(frame.filename).name}, line {frame.lineno}: "
                 for frame in traceback.extract_tb(error.__traceback__)
                 if frame.filename.endswith(".j2")]
        kind = "" if isinstance(error, DataError) else f"{type(error).__name__}: "
        raise DataError(f"{what}: {lines[-1] if lines else ''}{kind}{error}") from error


def draw(data, folder, name):
    with telling(f"figure {name}"):
        style.save(figures(data)[name](), folder, name)


def draw_all(data, folder):
    """All figures, on as many cores as there are."""
    folder.mkdir(parents=True, exist_ok=True)
    # Forked, so that a process has what its parent has read.
    with concurrent.futures.ProcessPoolExecutor(mp_context=multiprocessing.get_context("fork")) as pool:
        drawn = [pool.submit(draw, data, folder, name) for name in figures(data)]
        for _ in tqdm.tqdm(concurrent.futures.as_completed(drawn), total=len(drawn), desc="figures",
                           file=sys.stderr):
            pass
    for done in drawn:
        done.result()


def write_pages(results, data):
    """The pages in Markdown."""
    environment = templates()
    names = {"data": data, "measured": data.json("tools"), "choose": choose_a_format, "style": style,
             "operations": operations, "blocks": blocks, "bounds": bounds,
             "headline": headline, "table_3_2": table_3_2, "division_cycles": division_cycles,
             "error_against_cycles": error_against_cycles, "error_histograms": error_histograms,
             "features": features, "identification": identification, "scenes": scenes,
             "scenes_workload": scenes_workload, "growth": growth, "lever": lever, "stability": stability,
             "haptic_region": haptic_region, "rivals": rivals}
    for template, (name, needed) in PAGES.items():
        if data.has(needed):
            with telling(name):
                write_whole(results / name, page(environment, template, names))


def write_columns(folder, headers):
    """columns.json: what the columns of the data files hold, a line for each kind of file."""
    write_whole(folder / "columns.json", "[\n" + ",\n".join(map(json.dumps, headers)) + "\n]\n")


def write(results, experiments=(), headers=None):
    """Everything: what the columns hold, if that is given and there are data; the figures; then the pages that show
    them."""
    if headers is not None and (results / "data").is_dir():
        write_columns(results / "data", headers)
    data = Data(results / "data", experiments)
    draw_all(data, results / "figures")
    write_pages(results, data)
    environment = templates()
    if (results / "data" / "replay.json").exists():
        with telling("replay.html"):
            write_whole(results / "replay.html", replay.page(environment, data))
    if data.has("operations"):
        with telling("bounds.csv"):
            write_whole(results / "data" / "bounds.csv", bounds.text(data))
        with telling("index.html"):
            explorer.write(results / "index.html", environment, data, write_whole)


def differences(results, experiments=(), headers=None):
    """The pages and figures of a folder that do not follow from its data, and columns.json if not from the headers."""
    with tempfile.TemporaryDirectory() as scratch:
        made = pathlib.Path(scratch)
        (made / "data").mkdir()
        for path in (results / "data").iterdir():
            (made / "data" / path.name).symlink_to(path.resolve())
        write(made, experiments, headers)
        files = [path.relative_to(made) for folder in (made, made / "figures", made / "data")
                 for path in sorted(folder.iterdir()) if path.is_file() and not path.is_symlink()]
        return [file for file in files if not (results / file).is_file()
                or not filecmp.cmp(made / file, results / file, shallow=False)]


def columns_fault(data, headers):
    """The first difference of columns.json from the headers of the program, in words that name the column."""
    stored = data.headers
    names = {tuple(row): path.name for path in sorted(data.folder.glob("*.csv"))
             if (row := next(csv.reader(path.read_text(encoding="utf-8").splitlines()[:1]), None))}

    def of(*alike):
        return next((f"of {names[tuple(header)]}, " for header in alike if tuple(header) in names), "")

    def same(a, b):
        return list(a.items()) == list(b.items())
    missing = [header for header in headers if not any(same(header, each) for each in stored)]
    further = [header for header in stored if not any(same(header, each) for each in headers)]
    for header in missing:
        alike = nearest(header, further)
        if alike is None:
            return f"{of(header)}the record of fixbench with {listed(list(header))} is missing"
        place = of(header, alike)
        for column, holds in header.items():
            if column not in alike:
                return f"{place}column '{column}' of fixbench is missing"
            if alike[column] != holds:
                return f"{place}column '{column}' holds {alike[column]}, and {holds} in fixbench"
        for column in alike:
            if column not in header:
                return f"{place}column '{column}' is not in fixbench"
        number, (a, b) = next((i, pair) for i, pair in enumerate(zip(alike, header), 1) if pair[0] != pair[1])
        return f"{place}column {number} is '{a}', and '{b}' in fixbench"
    if further:
        return f"no record of fixbench has the columns {', '.join(further[0])}"
    return "is not in the order of fixbench"


def fault(file, results, experiments, headers):
    """What is wrong with a file that differs from what would be written, in a line."""
    path = results / file
    if file != pathlib.Path("data/columns.json"):
        return f"{path} does not follow from the data"
    # It follows from the program, not from the data.
    data = Data(results / "data", experiments)
    try:
        return f"{path}: {columns_fault(data, headers)}; `{data.made_by[path.name]}` writes it"
    except DataError as error:
        return str(error)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", required=True,
                        help="folder that has data/ and gets figures/ and the pages")
    parser.add_argument("--experiments", type=json.loads, default=[],
                        help="output of `fixbench --list --json`: which command makes which file")
    parser.add_argument("--columns", type=json.loads,
                        help="the columns of each kind of data file and what they hold, instead of data/columns.json")
    parser.add_argument("--measured-here", action="store_true",
                        help="the data were measured on this machine today: note its tools and the date")
    parser.add_argument("--check", action="store_true",
                        help="write nothing; fail if a page or figure does not follow from the data")
    arguments = parser.parse_args()
    results = pathlib.Path(arguments.results)
    try:
        with telling(str(results)):
            if arguments.check:
                wrong = differences(results, arguments.experiments, arguments.columns)
                for file in wrong:
                    print("report: " + fault(file, results, arguments.experiments, arguments.columns), file=sys.stderr)
                return 1 if wrong else 0
            if arguments.measured_here:
                note_tools(results / "data")
            write(results, arguments.experiments, arguments.columns)
    except (DataError, OSError) as error:
        print("\nreport: " + " ".join(str(error).removeprefix(f"{results}: ").split()),
              file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
