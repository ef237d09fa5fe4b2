# SPDX-License-Identifier: GPL-3.0-or-later
"""The style of every figure, and how it is saved: the same data give the same bytes."""
import re

import matplotlib

import catalogue

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# A label, a colour and a marker for each number format, the same on all pages. The toolchain's own families have one
# colour each, and their formats differ by the marker. The colour-blind can distinguish the colours (Okabe and Ito,
# 2008).
ACCUM, INTEGER = "#999999", "#444444"
FORMATS = {
    "q4_4": ("Q4.4", "#8c6d00", "*"),
    "q8_8": ("Q8.8", "#cc79a7", "D"),
    "q8_16": ("Q8.16", "#7b3294", "o"),
    "q12_12": ("Q12.12", "#7b3294", "s"),
    "q16_16": ("Q16.16", "#0072b2", "o"),
    "q8_24": ("Q8.24", "#009e73", "^"),
    "q32_32": ("Q32.32", "#56b4e9", "s"),
    "u8_8": ("U8.8", "#aa4499", "X"),
    "u16_16": ("U16.16", "#332288", "^"),
    "float": ("float", "#e69f00", "P"),
    "s8_7": ("GCC _Accum s8.7", ACCUM, "D"),
    "s16_15": ("GCC _Accum s16.15", ACCUM, "o"),
    "s32_31": ("GCC _Accum s32.31", ACCUM, "s"),
    "s16_47": ("GCC _Accum s16.47", ACCUM, "^"),
    "int8": ("int8_t", INTEGER, "*"),
    "int16": ("int16_t", INTEGER, "D"),
    "int32": ("int32_t", INTEGER, "o"),
    "int64": ("int64_t", INTEGER, "s"),
}
# The 2016 design, in any format.
PUBLISHED = ("2016 design", "#d55e00", "X")
# Another library, in any format.
RIVAL = ("another library", "#555555", "1")
OTHER = ("#000000", "*")
# For what is not a format: measured against published, verdicts, theory.
INK = "#222222"
PALE = "#bbbbbb"


def format_label(number_format):
    """"Q8.24" for "q8_24"."""
    if number_format in FORMATS:
        return FORMATS[number_format][0]
    return re.sub(r"^q(\d+)_(\d+)$", r"Q\1.\2", number_format)


def label(number_format, implementation="default"):
    """The label of a number format in an implementation."""
    plain = format_label(number_format)
    if implementation == "published":
        return f"{plain}, {PUBLISHED[0]}"
    if number_format == "float":
        return "avr-libc float"
    if implementation in ("default", "accum", "native"):
        return plain
    known = catalogue.IMPLEMENTATIONS.get(implementation, {"label": implementation})
    return f"{plain}, {known['label'].removeprefix('ours, ')}"


def colour(number_format, implementation="default"):
    """The style of the format, or of the 2016 design."""
    if implementation == "published":
        return PUBLISHED[1]
    return FORMATS[number_format][1] if number_format in FORMATS else OTHER[0]


def marker(number_format, implementation="default"):
    if implementation == "published":
        return PUBLISHED[2]
    return FORMATS[number_format][2] if number_format in FORMATS else OTHER[1]


def face(number_format, implementation="default"):
    """The marker's inside: pale with compensated integration, empty for another variant of a format that is not its default."""
    if implementation == "compensated":
        return PALE
    plain = implementation in ("default", "libc", "accum", "native", "published")
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


def named_by_order(svg):
    """The text with its clipping paths and markers named by their order. Their names are hashes of unrounded
    numbers, whose last bits depend on the processor."""
    names = dict.fromkeys(re.findall(r'id="([pm][0-9a-f]{10})"', svg))
    for number, name in enumerate(names, 1):
        names[name] = f"{name[0]}{number}"
    return re.sub(r'(?<=["#])[pm][0-9a-f]{10}(?=[")])', lambda name: names.get(name.group(), name.group()), svg)


def save(figure, folder, name):
    """Writes <name>.svg and <name>.png, each completely or not at all."""
    for suffix, options in ((".svg", {"metadata": {"Date": None}}),
                            (".png", {"dpi": 110, "metadata": {"Software": None}})):
        partial = folder / f".{name}.partial{suffix}"
        figure.savefig(partial, **options)
        if suffix == ".svg":
            partial.write_text(named_by_order(partial.read_text(encoding="utf-8")), encoding="utf-8")
        partial.replace(folder / (name + suffix))
    plt.close(figure)


def legend_above(figure, handles, labels, columns):
    """One legend for all panels, in a strip above them."""
    strip = 0.3 * -(-len(labels) // columns)  # inches
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - strip / figure.get_figheight()))
    figure.legend(handles, labels, loc="upper center", ncols=columns)
