#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures and writes the pages of results/ out of its data files."""
import argparse
import json
import pathlib
import subprocess
import sys

import jinja2
import tqdm

import division_cycles
import error_against_cycles
import error_along_input
import error_histograms
import growth
import haptic_region
import haptic_timing
import headline
import lever
import replay
import scenes
import scenes_workload
import stability
import style
import table_3_2
from data import Data

HERE = pathlib.Path(__file__).resolve().parent

# The page that a template becomes, where the data file that it is about is there.
PAGES = {
    "results.md.j2": ("README.md", "operations"),
    "engine.md.j2": ("engine.md", "scenes"),
    "stability.md.j2": ("stability.md", "stability"),
    "lever.md.j2": ("lever.md", "haptic"),
}


def figures(data):
    """Name and maker of each figure."""
    makers = {
        "headline": lambda: headline.draw(data),
        "table_3_2": lambda: table_3_2.draw(data),
        "division_cycles": lambda: division_cycles.draw(data),
        "error_against_cycles_32": lambda: error_against_cycles.draw(data, "32 bits"),
        "error_against_cycles_16": lambda: error_against_cycles.draw(data, "16 bits"),
        "error_against_cycles_64": lambda: error_against_cycles.draw(data, "64 bits"),
        "error_histograms": lambda: error_histograms.draw(data),
        "error_along_input": lambda: error_along_input.draw(data),
    }
    if data.has("scenes"):
        makers["scenes"] = lambda: scenes.draw(data)
        makers["scenes_time_steps"] = lambda: scenes.draw_time_steps(data)
    if data.has("growth"):
        makers["growth"] = lambda: growth.draw(data)
    if data.has("stability"):
        makers["stability_verdicts"] = lambda: stability.draw_verdicts(data)
        makers["stability_stiffness"] = lambda: stability.draw_stiffness(data)
        makers["stability_chain"] = lambda: stability.draw_chain(data)
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
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError):
        return "not found"
    return done.stdout.splitlines()[0].strip()


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


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", required=True,
                        help="folder that holds data/ and gets figures/ and README.md")
    parser.add_argument("--experiments", type=json.loads, default=[],
                        help="what `fixbench --list --json` prints: who makes which file")
    arguments = parser.parse_args()
    results = pathlib.Path(arguments.results)
    data = Data(results / "data", arguments.experiments)

    folder = results / "figures"
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in tqdm.tqdm(figures(data).items(), desc="figures", file=sys.stderr):
        style.save(draw(), folder, name)

    templates = jinja2.Environment(loader=jinja2.FileSystemLoader(HERE), trim_blocks=True,
                                   lstrip_blocks=True, keep_trailing_newline=True,
                                   undefined=jinja2.StrictUndefined)
    templates.filters["cell"] = cell
    names = {"data": data, "hashes": data.json("operations")["context"]["sha256"],
             "versions": tool_versions(), "scenes": scenes, "growth": growth, "lever": lever,
             "stability": stability, "haptic_region": haptic_region}
    for template, (page, needed) in PAGES.items():
        if not data.has(needed):
            continue
        write_whole(results / page, templates.get_template(template).render(names))
    if (results / "data" / "replay.json").exists():
        write_whole(results / "replay.html", replay.page(templates, data))


if __name__ == "__main__":
    main()
