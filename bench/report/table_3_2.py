# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 3.2: measured over published, cell by cell, with the band of 10%."""
import matplotlib.pyplot as plt

import style

# The table itself; the rows below it are single figures of the text.
CELLS = 24
FACES = {"reproduced": style.INK, "explained": style.PALE, "not reproducible": "white"}


def verdicts(data):
    """The number of the table's cells with each verdict."""
    cells = data.rows("table_3_2")[:CELLS]
    return {verdict: sum(row["verdict"] == verdict for row in cells) for verdict in FACES}


def hypothesis(data):
    """The row that the table is measured with, and the mean number of rows that a hypothesis reproduces."""
    rows = data.rows("table_3_2_hypotheses")
    chosen = [row for row in rows if row["measured_with"] == "yes"]
    return chosen[0], sum(row["within_10_percent"] for row in rows) / len(rows)


def draw(data):
    rows = data.rows("table_3_2")
    figure, axes = plt.subplots(figsize=(11, 3.8))
    axes.axhspan(0.9, 1.1, color="#eeeeee", zorder=1, label="within 10%")
    axes.axhline(1, color=style.PALE, linewidth=1, zorder=2)
    for verdict, face in FACES.items():
        mine = [(position, row["ratio"]) for position, row in enumerate(rows)
                if row["verdict"] == verdict]
        if mine:
            cells = sum(position < CELLS for position, _ in mine)
            axes.scatter(*zip(*mine), s=40, zorder=4, facecolors=face, edgecolors=style.INK,
                         label=f"{verdict}: {cells} + {len(mine) - cells}")
    axes.axvline(CELLS - 0.5, color=style.PALE, linewidth=1, linestyle=":")
    axes.set(yscale="log", ylabel="measured / published", xlim=(-0.7, len(rows) - 0.3))
    ticks = [0.5, 0.7, 1, 1.5, 2, 3]
    axes.set_yticks(ticks, [str(tick) for tick in ticks])
    axes.minorticks_off()
    axes.set_xticks(range(len(rows)), [f"{row['type']} {row['operation']}" for row in rows],
                    rotation=60, ha="right", fontsize=7)
    for side, align, text in ((-4, "right", f"the table's {CELLS} cells"), (4, "left", "+ figures from the text")):
        axes.annotate(text, (CELLS - 0.5, 0.52), fontsize=7, ha=align, xytext=(side, 0), textcoords="offset points")
    axes.legend(loc="upper left", ncols=4)
    return figure


def finding(data):
    counts = verdicts(data)
    return (f"Of the table's {CELLS} cells, this one hypothesis reproduces {counts['reproduced']}; "
            f"another hypothesis explains {counts['explained']} more, "
            f"and none explains the other {counts['not reproducible']}.")
