#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The replay page, compared with the recording that it is made from.
Usage: replay_page_test.py FIXBENCH REPORT_FOLDER SCRATCH_FOLDER NODE"""
import copy
import html.parser
import json
import math
import pathlib
import subprocess
import sys
import unittest

FIXBENCH, REPORT, SCRATCH, NODE = sys.argv[1:5]
sys.dont_write_bytecode = True
sys.path.insert(0, REPORT)
import jinja2  # noqa: E402

import data  # noqa: E402
import replay  # noqa: E402

TEMPLATES = jinja2.Environment(loader=jinja2.FileSystemLoader(REPORT), trim_blocks=True,
                               lstrip_blocks=True, keep_trailing_newline=True,
                               undefined=jinja2.StrictUndefined)


class Parsed(html.parser.HTMLParser):
    """Identifiers, addresses that the page refers to, and the text of each script."""

    def __init__(self, text):
        super().__init__()
        self.identifiers, self.addresses, self.scripts, self._script = set(), [], [], False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.identifiers.add(attributes.get("id"))
        self.addresses += [attributes[name] for name in ("src", "href") if name in attributes]
        self._script = tag == "script"
        if self._script:
            self.scripts.append("")

    def handle_data(self, text):
        if self._script:
            self.scripts[-1] += text

    def handle_endtag(self, tag):
        self._script = False


class ReplayPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = pathlib.Path(SCRATCH)
        subprocess.run([FIXBENCH, "lever", "--scenario", "demonstration", "--record", folder],
                       check=True, capture_output=True)
        cls.data = data.Data(folder)
        cls.recording = json.loads((folder / "replay.json").read_text(encoding="utf-8"))
        cls.text = replay.page(TEMPLATES, cls.data)
        cls.page = Parsed(cls.text)

    def test_embeds_the_recording_and_nothing_else(self):
        self.assertEqual(json.loads(self.page.scripts[0]), self.recording)

    def test_is_the_same_each_time(self):
        self.assertEqual(replay.page(TEMPLATES, self.data), self.text)

    def test_needs_nothing_from_elsewhere(self):
        self.assertTrue(self.page.addresses)
        for address in self.page.addresses:
            self.assertNotIn(":", address)
        self.assertNotIn("@import", self.text)
        self.assertNotIn("url(http", self.text)

    def test_is_small(self):
        self.assertLess(len(json.dumps(self.recording)), 300_000)

    def test_refuses_what_is_not_a_recording(self):
        def shorten(recording):
            recording["signals"]["lever"].pop()

        def rename(recording):
            recording["signals"]["levers"] = recording["signals"].pop("lever")

        def unplug(recording):
            del recording["pins"]["servo"]

        def crop(recording):
            recording["screens"][0]["cells"] = ""
        for change in (shorten, rename, unplug, crop):
            recording = copy.deepcopy(self.recording)
            replay.check(recording)
            change(recording)
            with self.assertRaises(replay.DataError, msg=change.__name__):
                replay.check(recording)

    def shown_at(self, time):
        """What the page's script has set at that time: attributes and texts by the element's name."""
        stage = pathlib.Path(__file__).with_name("replay_stage.js")
        given = json.dumps({"scripts": self.page.scripts, "time": time,
                            "identifiers": sorted(filter(None, self.page.identifiers))})
        done = subprocess.run([NODE, stage], input=given, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_shows_what_was_recorded(self):
        signals, sample = self.recording["signals"], self.recording["sample"]
        for k in (0, 150, 480, 520, 570, len(signals["lever"]) - 1):
            shown = self.shown_at(k * sample)
            self.assertEqual(shown["lever"]["transform"], f"rotate({signals['lever'][k] - 30:.3f})")
            self.assertEqual(shown["frame"]["transform"], f"rotate({signals['servo'][k] - 30:.3f})")
            angle, arm = math.radians(signals["told"][k] - 30), signals["arm"][k] * 1000
            self.assertAlmostEqual(shown["arm/1"]["cx"], -arm * math.cos(angle), places=6)
            self.assertAlmostEqual(shown["arm/1"]["cy"], -arm * math.sin(angle), places=6)
            told = shown["v-lever"]["text"].replace("\u2212", "-").split()[0]
            self.assertRegex(told, r"^-?\d+\.\d$")
            # A half in the second place may be rounded either way.
            self.assertLessEqual(abs(float(told) - signals["lever"][k]), 0.05 + 1e-9)
            held = shown["hand"]["opacity"] == 1
            self.assertEqual(held, bool(signals["held"][k]))
            screen = [each for each in self.recording["screens"]
                      if each["at"] <= (k + 1) * sample + 1e-6][-1]["cells"]
            for kind, name in ((".", "rod"), ("o", "weight"), ("#", "pivot")):
                self.assertEqual(shown[f"cells-{name}"].get("d", "").count("M"), screen.count(kind))
            pulse = shown["v-pulse"]["text"]
            if k > 10:
                # A thousandth of the pulse's 90 degrees is 1 us; the servo moves in 0.29 degrees.
                self.assertAlmostEqual(float(pulse.split()[0]), 1000 + signals["told"][k] / 0.09,
                                       delta=3)

    def test_finds_the_moments(self):
        moments = dict(self.shown_at(0)["moments"]["buttons"])
        self.assertAlmostEqual(moments["let go"], 2, delta=0.01)
        self.assertLess(moments["pushed"], moments["arm lengthened"])
        self.assertLess(moments["let go"], moments["at the stop"])
        self.assertLess(moments["at the stop"], moments["bounced"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
