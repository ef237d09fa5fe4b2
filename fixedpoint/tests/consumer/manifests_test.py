#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What Arduino and PlatformIO read of a library holds by their documentation, and is true.

Usage: manifests_test.py LIBRARY_FOLDER
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


# PlatformIO: docs.platformio.org, "library.json". The fields that there are, of which a misspelt one
# would go unnoticed, and the limits of the registry.
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

# One library, not three.
cmake = (library / "CMakeLists.txt").read_text()
project = re.search(r"project\((\w+) VERSION ([\d.]+)", cmake)
expect(project, "CMakeLists.txt: no project with a version")
for origin, name, version in [
        ("library.properties", properties.get("name"), properties.get("version")),
        ("CMakeLists.txt", *(project.groups() if project else (None, None)))]:
    expect((name, version) == (manifest["name"], manifest["version"]),
           f"{origin}: {name} {version}, library.json: {manifest['name']} {manifest['version']}")

# The words that the editor colours are words of the library.
source = "\n".join(path.read_text() for path in (library / "src").rglob("*.h*"))
known = set(re.findall(r"\w+", source))
for number, line in enumerate((library / "keywords.txt").read_text().splitlines(), 1):
    if not line or line.startswith("#"):
        continue
    word, *kind = line.split("\t")  # a tab, or the editor does not see it
    expect(kind in (["KEYWORD1"], ["KEYWORD2"], ["LITERAL1"]),
           f"keywords.txt:{number}: '{line}' is not WORD<tab>KIND")
    expect(word in known, f"keywords.txt:{number}: no '{word}' in src/")

for failure in failures:
    print(f"{library.name}/{failure}")
sys.exit(bool(failures))
