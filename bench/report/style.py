# SPDX-License-Identifier: GPL-3.0-or-later
"""How every figure looks, and how it is saved: the same data give the same bytes."""
import pathlib
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# A colour-blind-safe palette (Okabe and Ito, 2008) and a marker, in the order of the catalogue's
# implementations: one an implementation, everywhere.
STYLES = [("#0072b2", "o"), ("#999999", "s"), ("#d55e00", "X"), ("#56b4e9", "^"), ("#000000", "p"),
          ("#cc79a7", "P"), ("#e69f00", "D"), ("#8c6d00", "*"), ("#444444", ".")]
OTHER = ("#000000", "p")

CATALOGUE = pathlib.Path(__file__).parents[1] / "lab" / "catalogue" / "subjects.h"
# The rows X(implementation, ..., "label").
LABELS = dict(re.findall(r'^ *X\((\w+), .*"(.*)"\)$', CATALOGUE.read_text(encoding="utf-8"), re.M))
STYLE = dict(zip(LABELS, STYLES))

# A colour and a marker a number format. Rival families, GCC's _Accum and the plain integers, have a
# colour each and tell their formats apart by the marker.
FORMAT_STYLES = {
    "q4_4": ("#e69f00", "P"), "q8_8": ("#d55e00", "^"), "q16_16": ("#0072b2", "o"),
    "q8_24": ("#cc79a7", "D"), "q32_32": ("#009e73", "*"), "float": ("#444444", "s"),
    "s8_7": ("#8c6d00", "^"), "s16_15": ("#8c6d00", "o"), "s32_31": ("#8c6d00", "*"),
    "s16_47": ("#8c6d00", "D"),
    "int8": ("#999999", "P"), "int16": ("#999999", "^"), "int32": ("#999999", "o"),
    "int64": ("#999999", "*"),
}


def format_label(number_format):
    """Q16.16 of q16_16, _Accum s16.15 of s16_15, int32_t of int32."""
    family = number_format[0]
    if family == "q":
        return "Q" + number_format[1:].replace("_", ".")
    if family == "s":
        return "_Accum " + number_format.replace("_", ".")
    return number_format + "_t" if family == "i" else number_format


def label(implementation):
    return LABELS.get(implementation, "ours, " + implementation.replace("_", " "))


def colour(implementation):
    return STYLE.get(implementation, OTHER)[0]


def marker(implementation):
    return STYLE.get(implementation, OTHER)[1]


plt.rcParams.update({
    "font.size": 9,
    "axes.titlesize": 10,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "legend.frameon": False,
    "figure.constrained_layout.use": True,
    "svg.hashsalt": "fixedpoint",
    "svg.fonttype": "path",
})


def save(figure, folder, name):
    """Writes <name>.svg and <name>.png, each whole or not at all."""
    for suffix, options in ((".svg", {"metadata": {"Date": None}}),
                            (".png", {"dpi": 110, "metadata": {"Software": None}})):
        partial = folder / f".{name}.partial{suffix}"
        figure.savefig(partial, **options)
        partial.replace(folder / (name + suffix))
    plt.close(figure)


def legend_above(figure, handles, labels, columns):
    """One legend for all panels, in a strip above them."""
    strip = 0.3 * -(-len(labels) // columns)  # inches
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - strip / figure.get_figheight()))
    figure.legend(handles, labels, loc="upper center", ncols=columns)
