"""Readers of SU2, UGRID, Nastran, Abaqus, STL, OBJ and PLY files, written from what the formats'
descriptions say; they take nothing that is not there said, and guess nothing."""
import re
import struct

import numpy as np

SU2_KINDS = {3: ("line2", 2), 5: ("tri3", 3), 9: ("quad4", 4), 10: ("tet4", 4), 12: ("hex8", 8),
             13: ("prism6", 6), 14: ("pyramid5", 5)}


def su2(path):
    """Dimension, points (n, dimension), cells by kind, markers: name -> cells by kind."""
    lines = [line.split("%")[0].strip() for line in open(path, encoding="ascii")]
    lines = [line for line in lines if line]
    at = 0

    def keyword(name):
        nonlocal at
        key, value = lines[at].split("=")
        assert key.strip() == name, lines[at]
        at += 1
        return value.strip()

    def elements(count, numbered):
        nonlocal at
        found = {}
        for number in range(count):
            words = [int(word) for word in lines[at].split()]
            at += 1
            kind, size = SU2_KINDS[words[0]]
            assert len(words) == 1 + size + numbered
            if numbered:
                assert words[-1] == number
            found.setdefault(kind, []).append(words[1:1 + size])
        return found

    dimension = int(keyword("NDIME"))
    cells = elements(int(keyword("NELEM")), True)
    points = []
    for number in range(int(keyword("NPOIN"))):
        words = lines[at].split()
        at += 1
        assert len(words) == dimension + 1 and int(words[-1]) == number
        points.append([float(word) for word in words[:-1]])
    markers = {}
    for _ in range(int(keyword("NMARK"))):
        name = keyword("MARKER_TAG")
        assert not re.search(r"\s", name) and name not in markers
        markers[name] = elements(int(keyword("MARKER_ELEMS")), False)
    assert at == len(lines)
    return dimension, np.array(points), cells, markers


UGRID_KINDS = (("tet4", 4), ("pyramid5", 5), ("prism6", 6), ("hex8", 8))


def ugrid(path):
    """Points, cells by kind (nodes from 0, as in the file), surface numbers by kind."""
    if path.endswith((".b8.ugrid", ".lb8.ugrid")):
        take, ended = _binary(path, "<" if path.endswith(".lb8.ugrid") else ">")
    else:
        take, ended = _words(path)
    nodes, tris, quads, *volume = take("i", 7)
    points = np.array(take("d", 3 * nodes)).reshape(-1, 3)
    cells, surfaces = {}, {}
    for kind, size, count in (("tri3", 3, tris), ("quad4", 4, quads)):
        cells[kind] = np.array(take("i", size * count), int).reshape(-1, size) - 1
    for kind, count in (("tri3", tris), ("quad4", quads)):
        surfaces[kind] = np.array(take("i", count), int)
    for (kind, size), count in zip(UGRID_KINDS, volume):
        cells[kind] = np.array(take("i", size * count), int).reshape(-1, size) - 1
    assert ended()
    return points, cells, surfaces


def _words(path):
    words = open(path, encoding="ascii").read().split()
    at = 0

    def take(kind, count):
        nonlocal at
        at += count
        assert at <= len(words)
        return [float(word) if kind == "d" else int(word) for word in words[at - count:at]]

    return take, lambda: at == len(words)


def _binary(path, order):
    data = open(path, "rb").read()
    at = 0

    def take(kind, count):
        nonlocal at
        start, at = at, at + count * (8 if kind == "d" else 4)
        return list(struct.unpack(f"{order}{count}{kind}", data[start:at]))

    return take, lambda: at == len(data)


def mapbc(path):
    """Number -> (condition, name)."""
    first, *lines = open(path, encoding="ascii").read().splitlines()
    assert int(first) == len(lines)
    found = {}
    for line in lines:
        number, condition, name = line.split()
        found[int(number)] = (int(condition), name)
    return found


# By card and number of nodes.
BDF_KINDS = {("CTRIA3", 3): "tri3", ("CTRIA6", 6): "tri6", ("CQUAD4", 4): "quad4",
             ("CQUAD8", 8): "quad8", ("CTETRA", 4): "tet4", ("CTETRA", 10): "tet10",
             ("CPYRAM", 5): "pyramid5", ("CPYRAM", 13): "pyramid13", ("CPENTA", 6): "prism6",
             ("CPENTA", 15): "prism15", ("CHEXA", 8): "hex8", ("CHEXA", 20): "hex20"}
# G10 to G12 of a CPENTA and G13 to G16 of a CHEXA lie on the edges that stand on the first side.
BDF_ORDERS = {"prism15": (*range(9), 12, 13, 14, 9, 10, 11),
              "hex20": (*range(12), 16, 17, 18, 19, 12, 13, 14, 15)}


def bdf(path):
    """Points, cells by kind: (element, property, nodes from 0), lines, properties: number -> name,
    sets: name -> (kind, members), all in small and large fields."""
    lines = open(path, encoding="utf-8").read().splitlines()
    assert all(len(line) <= 80 for line in lines if not line.startswith("$"))
    lines = lines[lines.index("BEGIN BULK") + 1:]
    assert lines[-1] == "ENDDATA"
    names, sets = {}, {}
    cards, current = [], None
    for line in lines[:-1]:
        if line.startswith("$HMNAME COMP"):
            names[int(line[12:32])] = line[32:].strip('"')
        elif line.startswith("$HMSET"):
            sets[int(line[6:15])] = (line[24:].strip(' "'), int(line[15:23]))
        elif not line.startswith("$"):
            size = 16 if line[:8].rstrip().endswith("*") else 8
            fields = [line[i:i + size].strip() for i in range(8, min(72, len(line)), size)]
            if line[0] in "+*":
                current.extend(fields)
            else:
                current = [line[:8].strip().rstrip("*"), *fields]
                cards.append(current)
    return _bdf_cards(cards, names, sets)


def _bdf_cards(cards, names, sets):
    points, cells, plotted, properties, members = [], {}, [], set(), {}
    for name, *fields in cards:
        if name == "GRID":
            assert int(fields[0]) == len(points) + 1 and fields[1] == ""
            assert all("." in field for field in fields[2:5])
            points.append([float(field) for field in fields[2:5]])
        elif any(name == card for card, _count in BDF_KINDS):
            element, number, *nodes = [int(field) for field in fields if field]
            kind = BDF_KINDS[name, len(nodes)]
            nodes = [nodes[i] - 1 for i in BDF_ORDERS.get(kind, range(len(nodes)))]
            cells.setdefault(kind, []).append((element, number, nodes))
        elif name == "PLOTEL":
            plotted.append([int(field) - 1 for field in fields[1:3]])
        elif name in ("PSHELL", "PSOLID"):
            properties.add(int(fields[0]))
        elif name == "SET1":
            members[int(fields[0])] = [int(field) for field in fields[1:] if field]
        else:
            assert name == "MAT1", name
    assert properties == set(names) and set(members) == set(sets)
    found = {}
    for number, (name, kind) in sets.items():
        found[name, kind] = members[number]
    return np.array(points), cells, plotted, names, found


def obj(path):
    """Points, cells by number of corners and group."""
    points, cells, name = [], {}, None
    for line in open(path, encoding="ascii"):
        word, *rest = line.split()
        if word == "v":
            points.append([float(number) for number in rest])
        elif word == "g":
            name, = rest
        else:
            assert word in "fl"
            cells.setdefault((name, len(rest)), []).append([int(number) - 1 for number in rest])
    return np.array(points), cells


def stl(path):
    """Corners (m, 3, 3) and normals (m, 3) by solid."""
    words = iter(open(path, encoding="ascii").read().split())
    solids = {}

    def expect(text):
        for word in text.split():
            assert next(words) == word

    for word in words:
        assert word == "solid"
        name = next(words)
        triangles = solids.setdefault(name, [])
        while next(words) == "facet":
            expect("normal")
            normal = [float(next(words)) for _ in range(3)]
            expect("outer loop")
            corners = []
            for _ in range(3):
                expect("vertex")
                corners.append([float(next(words)) for _ in range(3)])
            expect("endloop endfacet")
            triangles.append((corners, normal))
        expect(name)
    return {name: (np.array([t[0] for t in found]), np.array([t[1] for t in found]))
            for name, found in solids.items()}
