#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The wiring diagram, the pin table of the README and the code name the same pins.

Usage: wiring_test.py FIRMWARE_FOLDER
"""
import re
import sys
import xml.etree.ElementTree
from pathlib import Path

firmware = Path(sys.argv[1])
failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)


def found(pattern, text, what):
    match = re.search(pattern, text)
    if not match:
        sys.exit(f"wiring_test.py: {what} is not where it was: /{pattern}/")
    return match.group(1)


# What the code drives and reads.
configuration = (firmware / "src/firmware/configuration.hpp").read_text()
board = (firmware / "src/firmware/hardware/atmega328p.hpp").read_text()
pins = {name: "A" + found(rf"{name}_input = (\d);", configuration, name)
        for name in ("sensor_a", "sensor_b", "dial")}
first = int(found(r"1 << \(PD(\d) \+ static_cast<uint8_t>\(category\)\)", board, "the first profiling pin"))
categories = found(r"enum class Category : uint8_t \{([^}]*)\}", configuration, "Category").split(",")
for number, category in enumerate(categories, first):
    pins[category.strip()] = f"D{number}"
pins["servo"] = "D" + found(r"servo_pin = 1 << PD(\d);", board, "the servo's pin")

# The diagram: a wire of that name ends on the dot of that pin, beside which the pin's name is read.
svg = xml.etree.ElementTree.parse(firmware / "wiring.svg")
space = "{http://www.w3.org/2000/svg}"
dots = {(float(dot.get("cx")), float(dot.get("cy"))): dot.get("id")
        for dot in svg.iter(space + "circle") if dot.get("class") == "pin"}
texts = [(float(text.get("x", 0)), float(text.get("y", 0)), text.text) for text in svg.iter(space + "text")]
for (x, y), pin in dots.items():
    beside = [text for at_x, at_y, text in texts if abs(at_x - x) < 16 and abs(at_y - y) < 8]
    expect(len(beside) == 1 and pin.startswith(beside[0].split()[0]), f"wiring.svg: {beside} beside pin {pin}")


def end(path):
    """Of a path of absolute M, L, H and V."""
    x = y = None
    for command, arguments in re.findall(r"([MLHV])([^A-Za-z]*)", path):
        numbers = [float(number) for number in arguments.split()]
        if command == "H":
            x = numbers[-1]
        elif command == "V":
            y = numbers[-1]
        else:
            x, y = numbers[-2:]
    return x, y


drawn = {}
for wire in svg.iter(space + "path"):
    if wire.get("data-name") in pins:
        drawn[wire.get("data-name")] = dots.get(end(wire.get("d")), "no pin")
expect(drawn == pins, f"wiring.svg: {drawn}; the code has {pins}")
for text, times in (("10 kΩ", 2), ("potentiometer, 10 kΩ", 1), ("7.5 V, 3 A", 1), ("common ground", 1)):
    expect(sum(text == label for _, _, label in texts) == times, f"wiring.svg: not {times} times '{text}'")

# The table.
readme = (firmware / "README.md").read_text()
expect("(wiring.svg)" in readme, "README.md: no link to wiring.svg")
table = {}
for names, ports, use in re.findall(r"^\| ([AD]\d(?:, [AD]\d)?) \| (P[CD]\d(?:, P[CD]\d)?) \| (.*) \|$", readme, re.M):
    for pin, port in zip(names.split(", "), ports.split(", ")):
        table[pin] = use
        expect(port == {"A": "PC", "D": "PD"}[pin[0]] + pin[1], f"README.md: {pin} is not {port}")
words = {"sensor_a": "force sensor", "sensor_b": "force sensor", "dial": "dial", "step": "step",
         "render": "frame", "collision": "contacts", "square_root": "square root", "operation": "product",
         "servo": "servo"}
for name, pin in pins.items():
    expect(words[name] in table.get(pin, ""), f"README.md: {pin} should be '{words[name]}': {table.get(pin)}")
expect(table.keys() == {*pins.values(), "D0", "D1"}, f"README.md: pins {sorted(table)}")

for failure in failures:
    print(failure)
sys.exit(bool(failures))
