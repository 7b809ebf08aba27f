#!/usr/bin/env python3
"""Counts the house: sizes, ways up between folders, rings of units, HTML in C++, texts that are fragments.

    tests/structure/count.py [ROOT]

Prints a table. The bounds that a test holds stand in floors_test.cpp.
"""

import collections
import csv
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parents[2])
ROOMS = ["config", "rockfall", "forest", "coupling", "validation"]
sys.setrecursionlimit(10_000)


def sources(room):
    return [f for f in (ROOT / room).rglob("*") if f.suffix in (".cpp", ".hpp") and "build" not in f.parts]


def lines(files):
    return sum(f.read_text(encoding="utf-8").count("\n") for f in files)


def includes():
    """Unit (a header with its source, without ending) -> the units it includes."""
    found = collections.defaultdict(set)
    for room in ROOMS:
        for file in sources(room):
            unit = file.relative_to(ROOT).as_posix().rsplit(".", 1)[0]
            found[unit] |= {name.rsplit(".", 1)[0] for name in re.findall(r'#include "([^"]+)"', file.read_text())}
            found[unit].discard(unit)
    return found


def folder(unit):
    return unit.rsplit("/", 1)[0]


def rings(graph):
    """Tarjan's strongly connected parts of more than one unit."""
    number, lowest, stack, found = {}, {}, [], []

    def visit(unit):
        number[unit] = lowest[unit] = len(number)
        stack.append(unit)
        for other in graph[unit]:
            if other not in graph:
                continue
            if other not in number:
                visit(other)
                lowest[unit] = min(lowest[unit], lowest[other])
            elif other in stack:
                lowest[unit] = min(lowest[unit], number[other])
        if lowest[unit] == number[unit]:
            part = stack[stack.index(unit):]
            del stack[stack.index(unit):]
            if len(part) > 1:
                found.append(part)

    for unit in list(graph):
        if unit not in number:
            visit(unit)
    return found


def is_fragment(text):
    """A text that other texts are glued to."""
    return bool(re.match(r"[ ,.;:]", text)) or text.endswith(" ") or "{part}" in text


TOKEN = re.compile(r'''//[^\n]*|/\*.*?\*/|'(?:\\.[^']*|[^'\\])'|R"([^(\s]*)\((.*?)\)\1"|"((?:\\.|[^"\\])*)"''', re.S)
TAG = re.compile(r"</?[a-z][a-z0-9-]*(?:[\s>/\\]|$)")


def lines_with_tags(code):
    """Lines in whose string literals a tag of HTML, SVG or another XML begins; not what stands between two."""
    found = set()
    for token in TOKEN.finditer(code):
        literal = 2 if token[2] is not None else 3
        for tag in TAG.finditer(token[literal] or ""):
            found.add(code.count("\n", 0, token.start(literal) + tag.start()))
    return found


def main():
    graph = includes()
    ways_up = [(u, t) for u in graph for t in graph[u] if t in graph and folder(u).startswith(folder(t) + "/")]
    between = [(u, t) for u in graph for t in graph[u] if u != "coupling/main" and t in graph
               and ROOMS.index(t.split("/")[0]) > ROOMS.index(u.split("/")[0])]
    units = collections.Counter(folder(u) for u in graph)
    html = [line for room in ("coupling", "validation") for f in sources(room)
            for line in lines_with_tags(f.read_text(encoding="utf-8"))]
    with open(ROOT / "coupling/results/text/pages.csv", encoding="utf-8", newline="") as file:
        texts = [row[0] for row in csv.reader(file)][1:]
    fragments = [text for text in texts if is_fragment(text)]
    product = [f for room in ROOMS for f in sources(room)]
    for name, value in [("lines of the product", lines(product)),
                        ("lines of coupling", lines(sources("coupling"))),
                        ("lines of tests", lines(sources("tests"))),
                        ("ways up between rooms", len(between)),
                        ("ways up inside rooms", len(ways_up)),
                        ("largest ring of units", max(map(len, rings(graph)), default=0)),
                        ("most units of a flat folder", max(units.values())),
                        ("lines of C++ that hold HTML or SVG", len(html)),
                        ("texts of pages", len(texts)),
                        ("texts that begin or end as a fragment", len(fragments))]:
        print(f"| {name} | {value:,} |".replace(",", " "))


main()
