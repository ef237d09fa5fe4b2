#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The files that Arduino and PlatformIO read conform to their documentation, and are true.

Usage: manifests_test.py LIBRARY_FOLDER [--fix]
  --fix  adds the words to keywords.txt that it lacks
"""
import json
import re
import sys
from pathlib import Path

import jsonschema

library = Path(sys.argv[1])
failures = []


def expect(condition, message):
    if not condition:
        failures.append(message)


# PlatformIO: docs.platformio.org, "library.json". The known fields, since a misspelt one would go
# unnoticed, and the limits of the registry.
text = {"type": "string", "minLength": 1, "maxLength": 255}
texts = {"anyOf": [text, {"type": "array", "items": text, "minItems": 1}]}


def fields(required=(), **properties):
    return {"type": "object", "properties": properties, "required": list(required),
            "additionalProperties": False}


library_json = fields(
    ["name", "version", "description", "keywords", "license"],
    **{"$schema": text},
    name={"type": "string", "pattern": r"^[A-Za-z0-9]+(-[A-Za-z0-9]+)*$", "maxLength": 50},
    version={"type": "string", "pattern": r"^\d+\.\d+\.\d+$", "maxLength": 20},
    description=text, keywords=texts, homepage=text, license=text,
    repository=fields(["type", "url"], type={"enum": ["git", "hg", "svn"]}, url=text, branch=text),
    authors={"type": "array", "items": fields(["name"], name=text, email=text, url=text,
                                              maintainer={"type": "boolean"})},
    frameworks=texts, platforms=texts, headers=texts,
    examples={"type": "array", "items": fields(["name", "base", "files"], name=text, base=text,
                                               files={"type": "array", "items": text})},
    dependencies={"anyOf": [
        {"type": "object", "additionalProperties": text},
        {"type": "array", "items": fields(["name"], owner=text, name=text, version=text,
                                          frameworks=texts, platforms=texts)}]},
    export=fields(include={"type": "array", "items": text}, exclude={"type": "array", "items": text}),
    scripts=fields(postinstall=texts, preuninstall=texts),
    build=fields(flags=texts, unflags=texts, includeDir=text, srcDir=text, srcFilter=texts,
                 extraScript=text, libArchive={"type": "boolean"},
                 libLDFMode={"enum": ["off", "chain", "deep", "chain+", "deep+"]},
                 libCompatMode={"enum": ["off", "soft", "strict"]}, builder=text))

manifest = json.loads((library / "library.json").read_text())
for error in jsonschema.Draft7Validator(library_json).iter_errors(manifest):
    failures.append(f"library.json: {'.'.join(map(str, error.absolute_path)) or 'field'}: {error.message}")
headers = manifest.get("headers", [])
for header in [headers] if isinstance(headers, str) else headers:
    expect((library / "src" / header).is_file(), f"library.json: no header src/{header}")
for example in manifest.get("examples", []):
    for name in example["files"]:
        expect((library / example["base"] / name).is_file(),
               f"library.json: no example {example['base']}/{name}")
for pattern in manifest.get("export", {}).get("include", []):
    expect(any(library.glob(pattern)), f"library.json: export.include: nothing is '{pattern}'")

# Arduino: the library specification 1.5.
properties = {}
for line in (library / "library.properties").read_text().splitlines():
    if line and not line.startswith("#"):
        key, separator, value = line.partition("=")
        expect(separator, f"library.properties: no '=' in '{line}'")
        expect(key not in properties, f"library.properties: {key} twice")
        properties[key] = value
required = {"name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url",
            "architectures"}
optional = {"depends", "includes", "license", "dot_a_linkage", "precompiled", "ldflags"}
expect(required <= properties.keys(), f"library.properties: lacks {required - properties.keys()}")
expect(properties.keys() <= required | optional,
       f"library.properties: unknown {properties.keys() - required - optional}")
expect(properties.get("category") in {
    "Display", "Communication", "Signal Input/Output", "Sensors", "Device Control", "Timing",
    "Data Storage", "Data Processing", "Other"}, "library.properties: category")
for header in properties.get("includes", "").split(","):
    expect((library / "src" / header.strip()).is_file(),
           f"library.properties: no header src/{header}")

# One library, not three; one project, whose address is in library.properties of fixedpoint.
for field in ("name", "version", "license"):
    expect(properties.get(field) == manifest[field],
           f"library.properties: {field} {properties.get(field)}, library.json: {manifest[field]}")
cmake = re.search(r"project\(\w+ VERSION ([\d.]+)", (library / "CMakeLists.txt").read_text())
if cmake:
    expect(cmake[1] == manifest["version"], f"CMakeLists.txt: version {cmake[1]}")
of_project = (library.parent / "fixedpoint/library.properties").read_text()
url = re.search(r"^url=(.+)$", of_project, re.M)[1]
for origin, found in [("library.properties: url", properties.get("url")),
                      ("library.json: homepage", manifest.get("homepage")),
                      ("library.json: repository", manifest.get("repository", {}).get("url", ""))]:
    expect(found.removesuffix(".git") == url, f"{origin} is '{found}', and the project's {url}")
depends = [name.strip() for name in properties.get("depends", "").split(",") if name]
expect(depends == [each["name"] for each in manifest.get("dependencies", [])],
       "library.properties and library.json depend on different libraries")
expect(manifest.get("examples", []) and {each["name"] for each in manifest["examples"]} ==
       {path.name for path in (library / "examples").iterdir()},
       "library.json names other examples than there are")

# vcpkg's manifest says the same (the Conan recipe reads library.json).
port = library / "vcpkg/vcpkg.json"
if port.exists():
    for field, value in json.loads(port.read_text()).items():
        expect(field == "dependencies" or value == manifest[field], f"vcpkg.json: {field} '{value}'")

# Rules of arduino-lint that do not need a network.
expect(re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9 ._-]{0,15}", properties["name"]),
       "library.properties: a name has letters, digits, blanks and ._-, 16 at most")
expect("arduino" not in properties["name"].lower(), "library.properties: a name without 'Arduino'")
expect(re.fullmatch(r"\d+\.\d+\.\d+", properties["version"]), "library.properties: version")
expect(re.match(r"https?://\S+$", properties["url"]), "library.properties: url")
for field in ("author", "maintainer", "sentence", "paragraph"):
    expect(properties[field].strip() == properties[field] != "", f"library.properties: {field}")
expect(not properties["paragraph"].startswith(properties["sentence"]),
       "library.properties: the paragraph repeats the sentence")
expect(properties["architectures"] in ("*", "avr"), "library.properties: architectures")
for name in ("README.md", "LICENSE", "keywords.txt", "examples"):
    expect((library / name).exists(), f"no {name}")
for path in (library / "examples").iterdir():
    expect((path / f"{path.name}.ino").is_file(), f"examples/{path.name}: no {path.name}.ino")
for path in library.rglob("*"):
    expect(not path.is_symlink() and path.name != ".development" and path.suffix != ".exe",
           f"{path.relative_to(library)} does not belong into a library")

# The words that the editor highlights are words of the library.
source = "\n".join(path.read_text() for path in (library / "src").rglob("*.h*"))
known = set(re.findall(r"\w+", source))
coloured = set()
for number, line in enumerate((library / "keywords.txt").read_text().splitlines(), 1):
    if not line or line.startswith("#"):
        continue
    word, *kind = line.split("\t")  # a tab; otherwise the editor ignores the line
    expect(kind in (["KEYWORD1"], ["KEYWORD2"], ["LITERAL1"]),
           f"keywords.txt:{number}: '{line}' is not WORD<tab>KIND")
    expect(word in known, f"keywords.txt:{number}: no '{word}' in src/")
    coloured.add(word)

# And all words that a program calls: the functions at the left edge of these headers, the members of
# the world that come before the parts of a step, and what is chosen by name.
OPERATIONS = {"fixedpoint": ("math", "conversion", "text", "serial", "printable", "vector")}
FUNCTION = r"^(?:\w[\w:<>,&* ]*[ >&])(\w+)\((?!.*;$)"
callable_words = set()
for stem in OPERATIONS.get(library.name, ()):
    text = (library / f"src/fixedpoint/{stem}.hpp").read_text()
    callable_words |= set(re.findall(FUNCTION, text, re.M))
for path in library.glob("src/fixedpoint/arithmetic/*.hpp"):
    callable_words |= {path.stem.title().replace("_", "")} - {"Wrapping"}
for path in [*library.glob("src/engine/*/*.hpp")]:
    callable_words |= set(re.findall(r"^struct (\w+) {\n    static constexpr bool", path.read_text(), re.M))
if library.name == "engine":
    world = (library / "src/engine/world.hpp").read_text()
    world = world[world.index("    /// Adds a particle"):world.index("    // The parts of a step, for")]
    callable_words |= set(re.findall(r"^    (?:const )?(?:[\w:<>,]+[&]? )+(\w+)\(", world, re.M))
lacking = sorted(callable_words - coloured)
if sys.argv[2:] == ["--fix"]:
    with (library / "keywords.txt").open("a") as words:
        words.writelines(f"{word}\tKEYWORD{1 if word[0].isupper() else 2}\n" for word in lacking)
else:
    expect(not lacking, f"keywords.txt: lacks {lacking}")

for failure in failures:
    print(f"{library.name}/{failure}")
sys.exit(bool(failures))
