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
