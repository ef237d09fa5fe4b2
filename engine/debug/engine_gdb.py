# SPDX-License-Identifier: MIT
"""Vectors and pools of the engine in gdb: a vector as its components, a pool as the elements that
are in it. Its numbers are shown by fixedpoint/debug/fixedpoint_gdb.py.

    (gdb) source fixedpoint/debug/fixedpoint_gdb.py
    (gdb) source engine/debug/engine_gdb.py"""

import gdb
import gdb.printing


class VectorPrinter:
    def __init__(self, value):
        self.component = value["component"]
        self.count = int(value.type.strip_typedefs().template_argument(1))

    def to_string(self):
        return None

    def children(self):
        return ((f"[{i}]", self.component[i]) for i in range(self.count))

    def display_hint(self):
        return "array"


class PoolPrinter:
    def __init__(self, value):
        self.capacity = int(value.type.strip_typedefs().template_argument(1))
        self.size = int(value["size_"]) if self.capacity else 0
        self.elements = value["elements_"] if self.capacity else None

    def to_string(self):
        return f"{self.size} of {self.capacity}"

    def children(self):
        return ((f"[{i}]", self.elements[i]) for i in range(self.size))

    def display_hint(self):
        return "array"


printers = gdb.printing.RegexpCollectionPrettyPrinter("engine")
printers.add_printer("Vector", "^engine::Vector<.*>$", VectorPrinter)
printers.add_printer("Pool", "^engine::(Pool|Elements)<.*>$", PoolPrinter)
gdb.printing.register_pretty_printer(None, printers, replace=True)
