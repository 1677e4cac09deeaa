#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Holds the floor plan of the library: what preprocessor/doc/architecture.md says of rooms is checked here.

    check_architecture.py REPOSITORY

A unit is a header and its source. Prints every fault and ends with 1 where there is one:
  - a loop of includes between units,
  - a room that includes what it does not link (its CMakeLists.txt),
  - a room, or a target of the plugin or of Python, that links one that is for the program only,
  - a type that is defined twice, or a namespace that is not the room's,
  - a class derived from Potential that is named where a Potential& should be taken,
  - a comment that refers to a header that does not exist,
  - a folder with more than 26 units,
  - a public header that does not exist, or that includes one that is not public.
"""
import collections
import pathlib
import re
import sys

MOST_UNITS = 26
# Plain data that all rooms exchange stands in namespace nanocarbon itself, as all of core does.
SHARED = {"mesh/triangle_mesh.h", "topology/bonds.h", "topology/rings.h", "molecule/molecule.h"}


def without_comments(text):
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


class Library:
    def __init__(self, repository):
        self.root = repository / "preprocessor" / "nanocarbon"
        self.text = {
            str(p.relative_to(self.root)): p.read_text()
            for p in sorted(self.root.rglob("*"))
            if p.suffix in (".h", ".cpp")
        }
        self.rooms = {}  # folder -> (target, namespace, linked targets)
        for cmake in sorted(self.root.rglob("CMakeLists.txt")):
            call = re.search(r"nanocarbon_room\(\s*(\w+)(.*?)\)", cmake.read_text(), re.S)
            links = re.search(r"\bLINKS\b(.*?)(?=PRIVATE_LINKS|NAMESPACE|$)", call.group(2), re.S)
            self.rooms[str(cmake.parent.relative_to(self.root))] = (
                call.group(1),
                self.namespace_of(call.group(1)),
                set(re.findall(r"nanocarbon::(\w+)", links.group(1))) if links else set(),
            )

    @staticmethod
    def namespace_of(target):
        """mesh_formats is a folder of room mesh and shares its namespace; core's is nanocarbon itself."""
        return "" if target == "core" else target.split("_")[0]

    def includes(self, file):
        return re.findall(r'^#include "nanocarbon/([^"]+)"', self.text[file], re.M)

    @staticmethod
    def unit(file):
        return re.sub(r"\.(h|cpp)(\.in)?$", "", file)

    @staticmethod
    def folder(file):
        return file.rsplit("/", 1)[0]


def loops(library):
    graph = collections.defaultdict(set)
    for file in library.text:
        for included in library.includes(file):
            if library.unit(included) != library.unit(file):
                graph[library.unit(file)].add(library.unit(included))
    index, low, stack, on_stack, found = {}, {}, [], set(), []

    def visit(v):  # Tarjan's strongly connected components
        index[v] = low[v] = len(index)
        stack.append(v)
        on_stack.add(v)
        for w in graph[v]:
            if w not in index:
                visit(w)
                low[v] = min(low[v], low[w])
            elif w in on_stack:
                low[v] = min(low[v], index[w])
        if low[v] == index[v]:
            component = []
            while not component or component[-1] != v:
                component.append(stack.pop())
                on_stack.discard(component[-1])
            if len(component) > 1:
                found.append(component)

    sys.setrecursionlimit(10000)
    for v in list(graph):
        if v not in index:
            visit(v)
    return [f"include loop: {', '.join(sorted(c))}" for c in found]


def links(library):
    targets = {target: folder for folder, (target, _, _) in library.rooms.items()}
    faults = []

    def reachable(target, seen):
        for linked in library.rooms[targets[target]][2]:
            if linked in targets and linked not in seen:
                seen.add(linked)
                reachable(linked, seen)
        return seen

    for file in library.text:
        folder = library.folder(file)
        if folder not in library.rooms:
            faults.append(f"{file}: its folder is no room (no nanocarbon_room() in a CMakeLists.txt)")
            continue
        target = library.rooms[folder][0]
        allowed = reachable(target, {target})
        for included in library.includes(file):
            room = library.rooms.get(library.folder(included))
            if room and room[0] not in allowed:
                faults.append(f"{file} includes {included}, but {target} does not link {room[0]}")
    return faults


def program_only(library, repository):
    """Rooms under another licence go into the program, and into nothing that others link."""
    files = [*library.root.rglob("CMakeLists.txt"), *(repository / "lammps-plugin").rglob("CMakeLists.txt"),
             *(repository / "preprocessor" / "python").rglob("CMakeLists.txt")]
    texts = {file: file.read_text() for file in files}
    rooms = [found for text in texts.values() for found in re.findall(r"nanocarbon_room\(\s*(\w+)\s+PROGRAM_ONLY", text)]
    faults = [] if rooms else ["no room is for the program only: has the word PROGRAM_ONLY changed?"]
    return faults + [f"{file.relative_to(repository)} links {room}, which is for the program only"
                     for file, text in texts.items() for room in rooms if f"nanocarbon::{room}" in text]


def types_and_namespaces(library):
    defined, faults = collections.defaultdict(list), []
    for file, text in library.text.items():
        code = without_comments(text)
        room = library.rooms.get(library.folder(file))
        expected = "nanocarbon"
        if room and room[1] and file not in SHARED:
            expected += "::" + room[1]
        # Another room's types may be declared, though not defined.
        own = re.sub(r"^namespace nanocarbon::\w+ \{\n(?:(?:class|struct) \w+;\n)+\}", "", code, flags=re.M)
        for namespace in re.findall(r"^namespace (nanocarbon[\w:]*) \{", own, re.M):
            if namespace != expected:
                faults.append(f"{file}: namespace {namespace} instead of {expected}")
        # A kernel's body is compiled once for each instruction set, in an unnamed namespace of its own.
        if file.endswith(".h") and not file.endswith("_kernel_body.h"):
            for name in re.findall(r"^(?:struct|class|enum class) (?:alignas\([^)]*\) )?(\w+)[^;{]*\{", code, re.M):
                defined[name].append(file)
            for name in re.findall(r"^using (\w+) =", code, re.M):
                defined[name].append(file)
    return faults + [f"type {n} is defined in {' and '.join(f)}" for n, f in defined.items() if len(f) > 1]


def potentials(library):
    """Whoever needs forces takes a Potential; one place below the program makes them."""
    classes = {}  # class -> its room's namespace
    for file, text in library.text.items():
        for name in re.findall(r"^class (\w+)[^;{]*: public (?:potential::)?Potential\b", without_comments(text), re.M):
            classes[name] = library.rooms[library.folder(file)][1]
    faults = [] if len(classes) > 1 else ["no potentials are found: has Potential another name?"]
    for file, text in library.text.items():
        if file.startswith("potential/") or file == "building/potential_choice.cpp":
            continue
        code = without_comments(text)
        faults += [f"{file} names {room}::{name}: let it take a Potential&" for name, room in classes.items()
                   if re.search(rf"\b{room}::{name}\b", code)]
    return faults


def headers_in_comments(repository):
    """What a comment refers to exists: "see room/unit.h"."""
    headers = ["/" + p.relative_to(repository).as_posix() for p in repository.glob("*/**/*.h")]
    faults = []
    for top in ("preprocessor", "lammps-plugin", "tests"):
        for file in sorted((repository / top).rglob("*")):
            if file.suffix not in (".h", ".cpp"):
                continue
            for comment in re.findall(r"//(.*)", file.read_text()):
                if "#include" in comment:
                    continue
                faults += [f"{file.relative_to(repository)} refers to {name}, which does not exist"
                           for name in re.findall(r"\b[a-z_]+(?:/[a-z0-9_]+)*\.h\b", comment)
                           if not any(h.endswith("/" + name) for h in headers)]
    return faults


def sizes(library):
    units = collections.defaultdict(set)
    for file in library.text:
        units[library.folder(file)].add(library.unit(file))
    return [f"{f} has {len(u)} units, more than {MOST_UNITS}" for f, u in units.items() if len(u) > MOST_UNITS]


def public_headers(library, repository):
    listed = re.findall(r"^\s+([\w/]+\.h)\b", (repository / "cmake" / "NanocarbonPublicHeaders.cmake").read_text(), re.M)
    faults = []
    for header in listed:
        if header == "core/version.h":  # made by CMake
            continue
        if header not in library.text:
            faults.append(f"public header {header} does not exist")
            continue
        faults += [
            f"public header {header} includes {included}, which is not public"
            for included in library.includes(header)
            if included not in listed
        ]
    return faults if listed else ["no public headers are listed"]


def main():
    repository = pathlib.Path(sys.argv[1])
    library = Library(repository)
    faults = loops(library) + links(library) + program_only(library, repository) + types_and_namespaces(library) + potentials(library)
    faults += headers_in_comments(repository) + sizes(library) + public_headers(library, repository)
    for fault in faults:
        print(fault)
    print(f"{len(library.text)} files in {len(library.rooms)} rooms, {len(faults)} fault(s)")
    return 1 if faults or len(library.text) < 100 else 0


if __name__ == "__main__":
    sys.exit(main())
