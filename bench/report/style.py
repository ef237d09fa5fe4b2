# SPDX-License-Identifier: GPL-3.0-or-later
"""How every figure looks, and how it is saved: the same data give the same bytes."""
import pathlib
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# A label, a colour and a marker for each number format, the same on all pages, and one for each that
# it is compared with. The colours can be told apart by the colour-blind (Okabe and Ito, 2008).
FORMATS = {
    "q4_4": ("Q4.4", "#8c6d00", "p"),
    "q8_8": ("Q8.8", "#cc79a7", "D"),
    "q16_16": ("Q16.16", "#0072b2", "o"),
    "q8_24": ("Q8.24", "#009e73", "^"),
    "q32_32": ("Q32.32", "#56b4e9", "s"),
    "float": ("float", "#e69f00", "P"),
}
RIVALS = {
    "published": ("2016 design", "#d55e00", "X"),
    "accum": ("GCC _Accum", "#999999", "d"),
    "native": ("integer", "#444444", "."),
}
OTHER = ("#000000", "*")
# What no format has: measured against published, verdicts, theory.
INK = "#222222"
PALE = "#bbbbbb"

CATALOGUE = pathlib.Path(__file__).parents[1] / "lab" / "catalogue" / "subjects.h"
# The rows X(implementation, ..., "label").
IMPLEMENTATIONS = dict(re.findall(r'^ *X\((\w+), .*"(.*)"\)$',
                                  CATALOGUE.read_text(encoding="utf-8"), re.M))


def format_label(number_format):
    """Q8.24 of q8_24."""
    if number_format in FORMATS:
        return FORMATS[number_format][0]
    return re.sub(r"^([qs])(\d+)_(\d+)$",
                  lambda match: f"{match[1].upper() if match[1] == 'q' else 's'}{match[2]}.{match[3]}",
                  number_format)


def label(number_format, implementation="default"):
    """How a number format in an implementation is called."""
    if implementation in RIVALS:
        name = RIVALS[implementation][0]
        return f"{format_label(number_format)}, {name}" if implementation == "published" else (
            f"{name} {format_label(number_format)}")
    if number_format == "float":
        return "avr-libc float"
    plain = format_label(number_format)
    if implementation == "default":
        return plain
    return f"{plain}, {IMPLEMENTATIONS.get(implementation, implementation).removeprefix('ours, ')}"


def colour(number_format, implementation="default"):
    """That of the format; of a rival its own."""
    return (RIVALS.get(implementation) or FORMATS.get(number_format) or ("", *OTHER))[1]


def marker(number_format, implementation="default"):
    return (RIVALS.get(implementation) or FORMATS.get(number_format) or ("", *OTHER))[2]


def face(number_format, implementation="default"):
    """The marker's inside: empty for a variant of a format beside its default."""
    plain = implementation in ("default", "libc") or implementation in RIVALS
    return colour(number_format, implementation) if plain else "white"


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
