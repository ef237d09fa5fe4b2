# SPDX-License-Identifier: MIT
"""Writes the header from which portable code reads the numbers of a table."""

from page import SOURCE, rows


def write(name, generator, sentence, structure, arrays):
    """src/fixedpoint/portable/<name>.hpp with a structure of arrays (type, member, numbers,
    format of a number)."""
    lines = [
        "// SPDX-License-Identifier: MIT",
        f"// DO NOT EDIT: written by python3 fixedpoint/tables/{generator}",
        *(f"// {line}" for line in sentence.split("\n")),
        "#pragma once", "",
        "#include <fixedpoint/program_memory.hpp>", "",
        "namespace fixedpoint {", "namespace portable {", "",
        "// A template, with Any = void, since its static members may be defined in a header.",
        "template <class Any = void>",
        f"struct {structure} {{",
    ]
    for kind, member, numbers, form in arrays:
        per_line = 8 if max(len(form.format(number)) for number in numbers) < 14 else 4
        lines += [f"    static constexpr {kind} {member}[{len(numbers)}] "
                  "FIXEDPOINT_PROGRAM_MEMORY = {",
                  ",\n".join(f"        {row}" for row in rows(numbers, per_line, form)) + "};"]
    lines.append("};")
    for kind, member, _, _ in arrays:
        lines += ["template <class Any>", f"constexpr {kind} {structure}<Any>::{member}[];"]
    lines += ["", "}  // namespace portable", "}  // namespace fixedpoint"]
    (SOURCE / "portable" / f"{name}.hpp").write_text("\n".join(lines) + "\n")
