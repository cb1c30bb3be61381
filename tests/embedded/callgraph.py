"""Worst-case stack from the call graph that GCC writes with -fcallgraph-info=su.

Every path from the entry is followed. What GCC cannot know is resolved here: calls through a
profile or an aligner by the tables in src/, the progress hook as the caller's own affair."""

import functools
import re

# Of the assembly in libgcc there is no call graph; none of its helpers that integers need pushes
# more than this [bytes].
LIBGCC_FRAME = 48
LIBGCC = re.compile(r"__(aeabi_|gnu_thumb1_|u?div|u?mod|mul|ashl|lshr|ashr)\w*$")


class GraphError(Exception):
    """Why no bound can be given."""


def read_tables(source):
    """{(struct, object): {member: function}} of the structs of functions in src/."""
    text = {file: file.read_text() for file in sorted(source.glob("*.[ch]"))}
    members = {}
    for content in text.values():
        for name, body in re.findall(r"struct (roomseg_\w+) \{(.*?)\n\};", content, re.S):
            found = [re.search(r"\(\*(\w+)\)\(", declaration)
                     for declaration in re.sub(r"/\*.*?\*/", "", body, flags=re.S).split(";")]
            if any(found):
                members[name] = [function and function[1] for function in found]
    tables = {}
    for file, content in text.items():
        for struct, name, values in re.findall(
                r"^const (roomseg_\w+) (roomseg_\w+) = \{([^}]*)\};", content, re.M):
            if struct in members:
                functions = [value.strip() for value in values.split(",")]
                tables[name] = {member: (file.name, function)
                                for member, function in zip(members[struct], functions)
                                if member}
    return tables


class CallGraph:
    """files: the .ci files. source: the folder src/. profile, aligner: the objects that the
    configuration names; aligner None: no alignment."""

    def __init__(self, files, source, profile, aligner):
        tables = read_tables(source)
        self.objects = {"profile": tables[profile], "align": tables[aligner] if aligner else {}}
        self.source = source
        self.frames, self.calls, self.places = {}, {}, {}
        for file in files:
            self.read(file.read_text())

    def read(self, text):
        for title, label in re.findall(r'^node: \{ title: "([^"]+)" label: "([^"]*)"', text, re.M):
            found = re.search(r"(\d+) bytes \((\w+)", label)
            if found:
                if found[2] != "static":
                    raise GraphError(f"the frame of {title} is {found[2]}")
                self.frames[title] = int(found[1])
        for caller, callee, place in re.findall(
                r'^edge: \{ sourcename: "([^"]+)" targetname: "([^"]+)"(?: label: "([^"]*)")?',
                text, re.M):
            self.calls.setdefault(caller, set()).add((callee, place))

    def titles(self, file, function):
        """Functions as GCC calls them: static ones with their file in front, parts and clones
        with a suffix."""
        found = [title for title in self.frames
                 if re.fullmatch(rf"(.*{re.escape(file)}:)?{re.escape(function)}(\..*)?", title)]
        if not found:
            raise GraphError(f"{function} of {file} is not in the call graph")
        return found

    def resolve(self, place):
        """Where a call through a pointer may go."""
        path, line = place.split(":")[:2]
        lines = (self.source / path.split("/")[-1]).read_text().splitlines()
        code = " ".join(lines[int(line) - 1:int(line) + 1])
        if "hook(" in code:
            return []
        found = re.search(r"(\w+)->(\w+)\(", code)
        if not found or found[1] not in self.objects:
            raise GraphError(f"call through an unknown pointer at {place}")
        table = self.objects[found[1]]
        return self.titles(*table[found[2]]) if table else []

    @functools.lru_cache(maxsize=None)
    def deepest(self, title):
        """(bytes, path) of the deepest chain of calls from a function on."""
        if title not in self.frames:
            if LIBGCC.match(title):
                return LIBGCC_FRAME, (title,)
            raise GraphError(f"no frame known for {title}")
        best = (0, ())
        for callee, place in sorted(self.calls.get(title, ())):
            targets = self.resolve(place) if callee == "__indirect_call" else [callee]
            for target in targets:
                best = max(best, self.deepest(target))
        return self.frames[title] + best[0], (title,) + best[1]

    def bound(self, entry):
        """Fails on recursion."""
        try:
            size, path = self.deepest(entry)
        except RecursionError:
            raise GraphError("recursion") from None
        return size, [title.split(":")[-1] for title in path]
