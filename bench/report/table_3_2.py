# SPDX-License-Identifier: GPL-3.0-or-later
"""Table 3.2, published and measured, cell by cell."""
import matplotlib.pyplot as plt

COLOURS = {"reproduced": "#009e73", "explained": "#e69f00", "not reproducible": "#d55e00"}


def draw(data):
    rows = data.rows("table_3_2")
    figure, axes = plt.subplots(figsize=(11, 4.2))
    positions = range(len(rows))
    for position, row in zip(positions, rows):
        axes.plot([position, position], [row["published_ms"], row["measured_ms"]], color="#bbbbbb",
                  linewidth=1.5, zorder=2)
    axes.scatter(positions, [row["published_ms"] for row in rows], marker="_", s=160, linewidths=2,
                 color="#222222", label="published", zorder=3)
    for verdict, colour in COLOURS.items():
        mine = [(position, row["measured_ms"]) for position, row in zip(positions, rows)
                if row["verdict"] == verdict]
        if mine:
            axes.scatter(*zip(*mine), color=colour, s=34, zorder=4,
                         label=f"measured: {verdict} ({len(mine)})")
    axes.set(yscale="log", ylabel="ms for 30000 operations", xlim=(-0.7, len(rows) - 0.3))
    axes.set_xticks(list(positions), [f"{row['type']} {row['operation']}" for row in rows],
                    rotation=60, ha="right", fontsize=7)
    axes.legend(loc="upper left", ncols=2)
    return figure
