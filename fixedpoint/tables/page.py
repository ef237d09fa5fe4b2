# SPDX-License-Identifier: MIT
"""Writes tables of bytes, by default each aligned to a page, so that an index is one register."""

from pathlib import Path

SOURCE = Path(__file__).parent.parent / "src/fixedpoint"


def rows(values, per_line=16, form="{:3d}"):
    texts = [form.format(value) for value in values]
    return [", ".join(texts[i:i + per_line]) for i in range(0, len(texts), per_line)]


def write_assembly(name, generator, sentence, pages, alignment=None):
    """src/fixedpoint/avr/<name>.S: symbol fixedpoint_<name>, pages as (title, bytes)."""
    symbol = f"fixedpoint_{name}"
    lines = [
        "// SPDX-License-Identifier: MIT",
        f"// DO NOT EDIT: written by python3 fixedpoint/tables/{generator}",
        *(f"// {line}" for line in sentence.split("\n")), "",
        "#ifdef __AVR_HAVE_MUL__", "#include \"prelude.inc\"", "",
        f"    TABLE {symbol}" + (f", {alignment}" if alignment else ""),
    ]
    for title, values in pages:
        lines.append(f"    // {title}")
        lines += [f"    .byte {row}" for row in rows(values)]
    lines += [f"    ENDTABLE {symbol}", "", "#endif"]
    (SOURCE / "avr" / f"{name}.S").write_text("\n".join(lines) + "\n")
