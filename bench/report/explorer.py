# SPDX-License-Identifier: GPL-3.0-or-later
"""The page for exploring the data, index.html: one file with the data, the views of explorer/ and the
plotting library, which opens from disk without a network."""
import fcntl
import hashlib
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import bounds
import catalogue
import rivals
import scenes
import style
from data import DataError

SOURCES = pathlib.Path(__file__).resolve().parent / "explorer"
BENCH = SOURCES.parents[1]

# The tables of the page. Those that a view draws come first; the table view shows all.
DRAWN = {
    "overview": ("operations", "accuracy", "exhaustive", "flash", "table_3_1"),
    "operations": ("operations", "accuracy", "exhaustive", "error_histograms", "error_along_input",
                   "rivals"),
    "scenes": ("scenes",),
    "stability": ("stability", "stability_map"),
}
LISTED = ("kernels", "table_3_2", "workload", "workload_firmware", "features", "growth", "envelope",
          "blocks", "limit_cycles", "suitability", "ablations", "haptic", "calibration_candidates", "stable_limits")

# A marker of matplotlib as the library's symbol and as a letter.
SYMBOLS = {"o": ("circle", "●"), "s": ("square", "■"), "^": ("triangle", "▲"), "D": ("diamond2", "◆"),
           "*": ("star", "★"), "P": ("cross", "✚"), "X": ("saltire", "✖"), "1": ("wye", "⅄")}

# How a case ends: its letter, the level of its shade (the louder the end, the darker), and its meaning.
VERDICTS = {
    "stable": ("S", 0, "held over the whole range; the limit is where the search ended"),
    "reports": ("R", 1, "the engine itself reports the error"),
    "saturates": ("A", 2, "a result stays at the end of the format"),
    "underflows": ("U", 3, "a product with the step rounds to zero"),
    "drifts": ("D", 4, "the error grows with time"),
    "overflows": ("O", 6, "a result leaves the format and wraps"),
    "diverges": ("X", 7, "growth without bound"),
}

# The largest magnitude of a result whose operands have magnitudes in [least, greatest], of the operations whose errors
# are compared across formats. Of all others nothing is known: tan, for one, is unbounded next to a pole.
LARGEST = {
    "add": lambda least, greatest: 2 * greatest,
    "subtract": lambda least, greatest: 2 * greatest,
    "multiply": lambda least, greatest: greatest ** 2,
    "divide": lambda least, greatest: greatest / least,
    "remainder": lambda least, greatest: greatest,
    "sqrt": lambda least, greatest: math.sqrt(greatest),
    "atan": lambda least, greatest: math.pi / 2,
    "atan2": lambda least, greatest: math.pi,
    "reciprocal_sqrt": lambda least, greatest: 1 / math.sqrt(least),
    "sin": lambda least, greatest: 1,
    "cos": lambda least, greatest: 1,
    "sincos": lambda least, greatest: 1,
    "exp": lambda least, greatest: math.exp(greatest),
    "log": lambda least, greatest: max(abs(math.log(least)), abs(math.log(greatest))),
    "asin": lambda least, greatest: math.pi / 2,
    "acos": lambda least, greatest: math.pi,
    "exp2": lambda least, greatest: 2 ** greatest,
    "expm1": lambda least, greatest: math.expm1(greatest),
    "log2": lambda least, greatest: max(abs(math.log2(least)), abs(math.log2(greatest))),
    "log10": lambda least, greatest: max(abs(math.log10(least)), abs(math.log10(greatest))),
    "log1p": lambda least, greatest: math.log1p(greatest),
    "sinh": lambda least, greatest: math.sinh(greatest),
    "cosh": lambda least, greatest: math.cosh(greatest),
    "tanh": lambda least, greatest: 1,
    "cbrt": lambda least, greatest: greatest ** (1 / 3),
    "pow": lambda least, greatest: greatest ** greatest,
    "sin_turns": lambda least, greatest: 1,
    "cos_turns": lambda least, greatest: 1,
    "sincos_turns": lambda least, greatest: 1,
    "atan2_turns": lambda least, greatest: 0.5,
    "sin_degrees": lambda least, greatest: 1,
    "cos_degrees": lambda least, greatest: 1,
    "sincos_degrees": lambda least, greatest: 1,
    "atan2_degrees": lambda least, greatest: 180,
    "divrem": lambda least, greatest: greatest / least,
    "divmod": lambda least, greatest: greatest / least,
    "lerp": lambda least, greatest: greatest * (1 + 2 * greatest),
    "smoothstep": lambda least, greatest: 1,
    "midpoint": lambda least, greatest: greatest,
    "abs_diff": lambda least, greatest: 2 * greatest,
    "copysign": lambda least, greatest: greatest,
    # The magnitude of the exponent is at most 8, and for -1 the result is the reciprocal.
    "power": lambda least, greatest: max(greatest ** 8, least ** -8),
    "sign": lambda least, greatest: 1,
    "isqrt": lambda least, greatest: greatest,
    "multiply_add": lambda least, greatest: greatest ** 2 + greatest,
    "dot2": lambda least, greatest: 2 * greatest ** 2,
    "dot3": lambda least, greatest: 3 * greatest ** 2,
    "length2": lambda least, greatest: math.sqrt(2) * greatest,
    "length3": lambda least, greatest: math.sqrt(3) * greatest,
    "normalise3": lambda least, greatest: 1,
}


def read(path):
    return (BENCH / path).read_text(encoding="utf-8")


def physics_operands(operation=None):
    """The smallest and the largest magnitude of the operands `physics`, for an operation or for most."""
    found = re.search(r"physics_least = ([\d.]+), physics_greatest = ([\d.]+), "
                      r"physics_greatest_of_exp = ([\d.]+);", read("lab/operands/operand_class.cpp"))
    if not found:
        raise DataError("lab/operands/operand_class.cpp: the limits of the class physics are missing")
    if operation in ("asin", "acos"):
        return float(found[1]), 1.0
    exponentials = ("exp", "exp2", "expm1", "sinh", "cosh")
    return float(found[1]), float(found[3 if operation in exponentials else 2])


def style_of(number_format, implementation):
    """The name whose colour and marker it has."""
    if implementation == "published":
        return "published"
    return number_format if number_format in style.FORMATS else "other"


def subject(number_format, implementation):
    """The label and style of a format in an implementation."""
    if implementation in rivals.NAMES:
        return {"label": rivals.label(number_format, implementation), "style": "rival",
                "hollow": False}
    return {"label": style.label(number_format, implementation),
            "style": style_of(number_format, implementation),
            "hollow": style.face(number_format, implementation) == "white"}


def number_format(name, data):
    """The range and resolution of a format."""
    drawn = {"label": style.format_label(name), "style": name if name in style.FORMATS else "rival"}
    if name == "float64":  # that of Python
        return drawn | {"fraction": None, "maximum": sys.float_info.max, "resolution": None,
                        "relative": sys.float_info.epsilon / 2}
    if name == "float":
        row, = data.rows("table_3_1", format="float")
        return drawn | {"fraction": None, "maximum": row["maximum"], "resolution": None,
                        "relative": row["relative_error_at_1"]}
    family, whole, fraction = re.fullmatch(r"([qsu]|int)(\d+)(?:_(\d+))?", name).groups()
    fraction = int(fraction or 0)
    resolution = 2.0 ** -fraction
    # The sign counts as a bit in a Q format and in an integer, not in an _Accum, and U formats have none.
    maximum = 2.0 ** (int(whole) - (family not in ("s", "u"))) - resolution
    return drawn | {"fraction": fraction, "maximum": maximum, "resolution": resolution,
                    "relative": None}


def compared(formats, names):
    """For each operation the formats that hold every operand and every result of the class physics: these share their
    domain, and their errors can be compared. The plain integers round their operands."""
    held = {}
    for name in names:
        least, greatest = physics_operands(name)
        largest = max(greatest, LARGEST[name](least, greatest)) if name in LARGEST else math.inf
        held[name] = [each for each, facts in formats.items()
                      if facts["fraction"] != 0 and facts["maximum"] > largest]
    return held


def require_known(file, column, found, known):
    unknown = {str(each) for each in found} - set(known)
    if unknown:
        raise DataError(f"{file}.csv, column {column}: the explorer does not know "
                        + ", ".join(sorted(unknown)))


def literal(value):
    """A cell as JSON. JSON has no infinity, but reads a number beyond the range of double as infinity; an integer that
    a double cannot hold becomes text."""
    if isinstance(value, float) and math.isinf(value):
        return "1e999" if value > 0 else "-1e999"
    if isinstance(value, int) and abs(value) > 2 ** 53:
        return f'"{value}"'
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def column(values):
    """A column as JSON: its cells or, if that is shorter, its few values and their indices."""
    cells = [literal(value) for value in values]
    different = list(dict.fromkeys(cells))
    plain = f"[{','.join(cells)}]"
    number = {cell: str(index) for index, cell in enumerate(different)}
    coded = f'{{"values":[{",".join(different)}],"index":[{",".join(number[cell] for cell in cells)}]}}'
    return min(plain, coded, key=len)


def table(rows, command):
    columns = ",".join(f"{json.dumps(name)}:{column([row[name] for row in rows])}" for name in rows[0])
    return f'{{"rows":{len(rows)},"command":{json.dumps(command)},"columns":{{{columns}}}}}'


def gather(data):
    """Everything that the page contains, as JSON."""
    views = {view: names for view, names in DRAWN.items() if data.has(names[0])}
    names = list(dict.fromkeys(name for drawn in views.values() for name in drawn))
    # The exhaustive run takes hours, and the rivals need their sources: both may be missing.
    names = [name for name in names
             if name not in ("exhaustive", "flash", "rivals") or data.has(name)]
    names += [name for name in LISTED if data.has(name)]
    measured = data.rows("operations")
    context = data.json("operations")["context"]
    known = dict(catalogue.IMPLEMENTATIONS)
    require_known("operations", "implementation", (row["implementation"] for row in measured), known)
    drawn = {row["format"] for row in measured}
    drawn = {name: look for name, look in style.FORMATS.items() if name in drawn}
    kinds = {(name, "default"): None for name in drawn}
    kinds |= {(row["format"], row["implementation"]): None for row in measured}
    require_known("operations", "format", (name for name, _ in kinds), style.FORMATS)
    others = {(row["format"], row["variant"]): None for row in rivals.comparable(data)}
    known |= {name: {"provenance": "rival", "label": text, "as_default": False}
              for name, text in rivals.NAMES.items() if name in {each for _, each in others}}
    formats = {name: number_format(name, data)
               for name in [*drawn, *(name for name, _ in others)]}
    scalars = {}
    if "scenes" in views:
        shown = [row for row in data.rows("scenes") if row["cycles_per_simulated_second"] is not None]
        require_known("scenes", "scalar", (row["scalar"] for row in shown if not scenes.is_split(row)),
                      style.FORMATS)
        scalars |= {(row["scalar"], row["arithmetic"]): None for row in shown}
    if "stability" in views:
        cases = data.rows("stability")
        require_known("stability", "scalar", (row["scalar"] for row in cases), style.FORMATS)
        scalars |= {(row["scalar"], row["arithmetic"]): None for row in cases}
        require_known("stability", "verdict", (row["verdict"].split()[0] for row in cases), VERDICTS)
        require_known("stability_map", "scalar",
                      (row["scalar"] for row in data.rows("stability_map")), style.FORMATS)
    facts = {
        "views": list(views) + ["table"],
        "styles": {name: dict(zip(("label", "colour", "symbol", "letter"),
                                  (label, colour, *SYMBOLS[marker])))
                   for name, (label, colour, marker) in
                   (drawn | {"published": style.PUBLISHED, "rival": style.RIVAL,
                                     "other": ("best split of 32 bits", *style.OTHER)}).items()},
        "formats": formats,
        "implementations": known,
        "subjects": {"/".join(kind): subject(*kind) for kind in [*kinds, *others]},
        "scalars": {f"{scalar}/{arithmetic}": subject(scalar, scenes.IMPLEMENTATION.get(arithmetic, arithmetic))
                    | ({"label": "float"} if scalar == "float" else {})
                    for scalar, arithmetic in scalars},
        "physics": physics_operands(),
        "compared": compared(formats, list(dict.fromkeys(row["operation"] for row in measured))),
        "hertz": context["mhz_per_cpu"] * 1e6,
        "verdicts": VERDICTS,
    }
    tables = {name: table(data.rows(name), data.made_by.get(name + ".csv")) for name in names}
    tables["bounds"] = table(bounds.table(data), "fixbench report")
    tables = ",".join(f"{json.dumps(name)}:{coded}" for name, coded in tables.items())
    return f'{json.dumps(facts, ensure_ascii=False)[:-1]}, "tables":{{{tables}}}}}'


class NoRegistry(Exception):
    """The packages are not installed, and their registry cannot be reached."""


def install():
    """Installs what package-lock.json pins, unless it is already installed."""
    lock = SOURCES / "package-lock.json"
    wanted = hashlib.sha256(lock.read_bytes()).hexdigest()
    stamp = SOURCES / "node_modules" / "installed-lock"
    with open(SOURCES / "package.json", encoding="utf-8") as guard:
        fcntl.flock(guard, fcntl.LOCK_EX)
        if stamp.exists() and stamp.read_text(encoding="utf-8") == wanted:
            return
        try:
            done = subprocess.run(["npm", "ci", "--no-audit", "--no-fund", "--ignore-scripts"],
                                  cwd=SOURCES, capture_output=True, text=True)
        except OSError as error:
            raise NoRegistry(f"npm cannot be run: {error}") from None
        no_way = re.search("ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH|_CERT_|"
                           "CERT_IN_CHAIN", done.stderr)
        if no_way:
            raise NoRegistry(f"no way to the npm registry ({no_way.group()})")
        if done.returncode:
            raise DataError("npm ci failed: " + " ".join(done.stderr.split()))
        stamp.write_text(wanted, encoding="utf-8")


def bundle():
    """The views and the library as one script, and the names of the packages in it."""
    install()
    with tempfile.TemporaryDirectory() as folder:
        script, parts = pathlib.Path(folder) / "script.js", pathlib.Path(folder) / "parts.json"
        done = subprocess.run(["node", "node_modules/esbuild/bin/esbuild", "main.js", "--bundle",
                               "--minify", "--format=iife", "--target=es2022", "--charset=utf8",
                               "--legal-comments=none", "--log-level=error",
                               f"--outfile={script}", f"--metafile={parts}"],
                              cwd=SOURCES, capture_output=True, text=True)
        if done.returncode:
            raise DataError("esbuild failed: " + " ".join(done.stderr.split()))
        inputs = json.loads(parts.read_text(encoding="utf-8"))["inputs"]
        packages = {found[1] for found in (re.match(r"node_modules/((?:@[^/]+/)?[^/]+)/", path)
                                           for path in inputs) if found}
        return script.read_text(encoding="utf-8"), sorted(packages)


def licences(packages):
    """Name, version and licence of each package."""
    lock = json.loads((SOURCES / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    told = []
    for name in packages:
        path = f"node_modules/{name}"
        file = next(iter(sorted((SOURCES / path).glob("LICENSE*"))), None)
        if file is None:
            raise DataError(f"explorer: {name} has no file LICENSE")
        told.append({"name": name, "version": lock[path]["version"], "licence": lock[path]["license"],
                     "text": file.read_text(encoding="utf-8").strip()})
    return told


def page(templates, data):
    script, packages = bundle()
    # Within a script element `</` would end it.
    return templates.get_template("explorer/index.html.j2").render(
        json=gather(data).replace("</", "<\\/"), script=script.replace("</script", "<\\/script"),
        licences=licences(packages))


def write(path, templates, data, write_whole):
    """Writes the page. If the library is not available, says so and leaves the page unchanged."""
    try:
        write_whole(path, page(templates, data))
    except NoRegistry as reason:
        print(f"report: {path.name} is not written: {reason}", file=sys.stderr)


if __name__ == "__main__":
    # What cannot be installed is told here; the test of the page skips or fails.
    try:
        install()
    except (NoRegistry, DataError) as reason:
        print(f"explorer: {reason}", file=sys.stderr)
