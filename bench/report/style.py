# SPDX-License-Identifier: GPL-3.0-or-later
"""How every figure looks, and how it is saved: the same data give the same bytes."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

# A colour-blind-safe palette (Okabe and Ito, 2008). One colour an implementation, everywhere.
COLOURS = {
    "default": "#0072b2",
    "saturating": "#56b4e9",
    "truncating": "#009e73",
    "small": "#cc79a7",
    "portable": "#999999",
    "published": "#d55e00",
    "libc": "#e69f00",
    "accum": "#8c6d00",
    "native": "#444444",
}
MARKERS = {
    "default": "o",
    "saturating": "^",
    "truncating": "v",
    "small": "P",
    "portable": "s",
    "published": "X",
    "libc": "D",
    "accum": "*",
    "native": ".",
}
LABELS = {
    "default": "ours, default",
    "saturating": "ours, saturating",
    "truncating": "ours, truncating",
    "small": "ours, small tables",
    "portable": "ours, portable C++",
    "published": "2016 design",
    "libc": "avr-libc float",
    "accum": "GCC _Accum",
    "native": "plain integer",
}


def label(implementation):
    return LABELS.get(implementation, "ours, " + implementation.replace("_", " "))


def colour(implementation):
    return COLOURS.get(implementation, "#000000")


def marker(implementation):
    return MARKERS.get(implementation, "p")


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
