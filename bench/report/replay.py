# SPDX-License-Identifier: GPL-3.0-or-later
"""The page that replays a recording of the lever: one file with all that it needs."""
import json

from data import DataError

SIGNALS = ("lever", "servo", "told", "hand", "force_a", "force_b", "reading_a", "reading_b", "arm",
           "held")
CELLS = 20 * 20
ARITHMETIC = {"q16_16": "Q16.16", "published": "the published arithmetic", "float": "float"}


def check(recording):
    """Raises DataError unless the page can show the recording."""
    def require(held, what):
        if not held:
            raise DataError(f"replay.json: {what}; fixbench lever writes it")
    signals = recording["signals"]
    require(set(signals) == set(SIGNALS), f"the signals are not {', '.join(SIGNALS)}")
    lengths = {len(values) for values in signals.values()}
    require(len(lengths) == 1 and min(lengths) > 1, "the signals differ in length or are empty")
    require(set(recording["pins"]) == {"step", "render", "servo"},
            "the pins are not step, render, servo")
    require(recording["screens"] and all(len(screen["cells"]) == CELLS
                                         for screen in recording["screens"]),
            "a screen does not have 20 x 20 cells")


def page(templates, data):
    recording = data.json("replay")
    check(recording)
    # Within a script element `</` would end it.
    embedded = json.dumps(recording, separators=(",", ":")).replace("</", "<\\/")
    return templates.get_template("replay.html.j2").render(
        recording=recording, arithmetic=ARITHMETIC[recording["arithmetic"]], json=embedded)
