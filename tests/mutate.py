#!/usr/bin/env python3
"""Do the tests notice when the library is wrong?

    tests/mutate.py [--count N] [--seed S] [--file NAME] [--list]

Changes one operator or constant of src/ at a time, N of all such places drawn by a seeded
generator, and runs the stage, interface and limits tests with it, the quick ones first, until one
fails; where none does, the golden ones, which compare with what the library once gave. A change
that no test notices has survived. Works on a copy in build/mutate, where the library is a shared
one, so that a change costs one compilation. Exit code 1 when less than 90 % were noticed. A change
that does not compile is not counted, and neither is one that tests/equal_mutants.txt lists,
because it makes no difference. About 5 s a change.
"""

import argparse
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / "build" / "mutate"
LEAST = 0.9
# Left out of the limits: what is long, and has nothing to say that the others have not.
TESTS = ["-R", "^(stage|api|limits|golden)", "-E", "limits_(cancel|two_threads)"]
# Lines as they are after a change that makes no difference, each with the reason.
EQUAL = ROOT / "tests" / "equal_mutants.txt"
SWAPS = {"<=": "<", ">=": ">", "<": "<=", ">": ">=", "==": "!=", "!=": "==", "&&": "||",
         "||": "&&", "+": "-", "-": "+", "*": "+", "/": "*", "<<": ">>", ">>": "<<", "&": "|"}
OPERATOR = re.compile(r"(?<=\s)(<=|>=|==|!=|&&|\|\||<<|>>|[-+*/<>&])(?=\s)")
CONSTANT = re.compile(r"(?<![\w.])(\d+)u?(?![\w.])")
# Neither comments nor texts for people.
COMMENT = re.compile(r"/\*.*?\*/|\"[^\"\n]*\"", re.DOTALL)


class Mutant:
    """One change: bytes start..end of a file become `text`."""

    def __init__(self, path: str, source: str, span: tuple[int, int], text: str):
        self.path, self.text = path, text
        self.start, self.end = span
        line = source.count("\n", 0, self.start)
        changed = source[:self.start] + text + source[self.end:]
        self.key = f"{path}: {changed.splitlines()[line].strip()}"
        self.words = (f"{path}:{line + 1}: {source[self.start:self.end]} -> {text}: "
                      f"{changed.splitlines()[line].strip()}")

    def __str__(self) -> str:
        return self.words


def find_mutants() -> list[Mutant]:
    mutants: list[Mutant] = []
    equal = set(re.findall(r"^(?!#).+$", EQUAL.read_text(encoding="utf-8"), re.MULTILINE))
    for path in sorted((ROOT / "src").glob("*.c")):
        source = path.read_text(encoding="utf-8")
        # Blank out comments, directives and asserts, so that positions stay.
        code = COMMENT.sub(lambda m: re.sub(r"\S", " ", m.group()), source)
        code = re.sub(r"^(#|RS_STATIC_ASSERT|const char).*(\\\n.*)*$",
                      lambda m: re.sub(r"[^\n]", " ", m.group()), code, flags=re.MULTILINE)
        for match in OPERATOR.finditer(code):
            mutants.append(Mutant(path.name, source, match.span(1), SWAPS[match.group(1)]))
        for match in CONSTANT.finditer(code):
            mutants.append(Mutant(path.name, source, match.span(1),
                                  str(int(match.group(1)) + 1)))
    for key in sorted(equal - {mutant.key for mutant in mutants}):
        print(f"mutate: {EQUAL.name}: there is no such change: {key}", file=sys.stderr)
    return [mutant for mutant in mutants if mutant.key not in equal]


class Test:
    """One test program, and how long it may take before it counts as failed."""

    def __init__(self, name: str, command: list[str]):
        self.name, self.command, self.seconds = name, command, 300.0

    def passes(self) -> bool:
        return run(self.command, self.seconds)

    def measure(self) -> bool:
        begin = time.monotonic()
        good = self.passes()
        self.seconds = 15.0 + 10.0 * (time.monotonic() - begin)
        return good


def prepare() -> list[Test]:
    """Builds everything once; the tests, quick ones first, golden ones last."""
    shutil.rmtree(WORK, ignore_errors=True)
    shutil.copytree(ROOT, WORK / "copy",
                    ignore=shutil.ignore_patterns("build", ".git", "out"))
    lists = WORK / "copy" / "CMakeLists.txt"
    text = lists.read_text(encoding="utf-8")
    lists.write_text(text.replace("add_library(roomseg STATIC", "add_library(roomseg SHARED"),
                     encoding="utf-8")
    configure = ["cmake", "-S", WORK / "copy", "-B", WORK / "build",
                 "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_C_FLAGS_RELEASE=-O1"]
    if (ROOT / "build" / "unity").is_dir():
        configure.append(f"-DUNITY_DIR={ROOT / 'build' / 'unity'}")
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    if not build("all"):
        sys.exit("mutate: the tests cannot be built")
    shown = subprocess.run(["ctest", "--test-dir", WORK / "build", "--show-only=json-v1", *TESTS],
                           check=True, capture_output=True).stdout
    tests = [Test(test["name"], test["command"]) for test in json.loads(shown)["tests"]]
    if len(tests) < 20:
        sys.exit("mutate: the tests were not built; tools/setup.sh test installs what is missing")
    for test in tests:
        if not test.measure():
            sys.exit(f"mutate: {test.name} fails without any change")
    return sorted(tests, key=lambda test: (test.name.startswith("golden"), test.seconds))


def run(command: list, seconds: float) -> bool:
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=seconds, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def build(target: str) -> bool:
    return run(["cmake", "--build", WORK / "build", "-j", "2", "--target", target], 1200)


def try_mutant(mutant: Mutant, tests: list[Test]) -> str:
    """The name of the test that noticed, "SURVIVED" or "invalid"."""
    path = WORK / "copy" / "src" / mutant.path
    source = path.read_text(encoding="utf-8")
    path.write_text(source[:mutant.start] + mutant.text + source[mutant.end:], encoding="utf-8")
    verdict = "SURVIVED"
    if not build("roomseg"):
        verdict = "invalid"
    else:
        for test in tests:
            if not test.passes():
                verdict = test.name
                break
    path.write_text(source, encoding="utf-8")
    return verdict


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", help="only places in this file of src/")
    parser.add_argument("--list", action="store_true", help="only print the sample")
    arguments = parser.parse_args()
    mutants = [m for m in find_mutants() if arguments.file in (None, m.path)]
    sample = random.Random(arguments.seed).sample(mutants, min(arguments.count, len(mutants)))
    if arguments.list:
        print(*sample, sep="\n")
        return 0
    tests = prepare()
    noticed = golden = survived = 0
    for mutant in sample:
        verdict = try_mutant(mutant, tests)
        survived += verdict == "SURVIVED"
        golden += verdict == "golden"
        noticed += verdict not in ("SURVIVED", "invalid")
        print(f"{verdict:24}{mutant}", flush=True)
    tried = noticed + survived
    print(f"{noticed} of {tried} noticed ({100.0 * noticed / max(tried, 1):.1f} %), {golden} of"
          f" them by the golden tests alone; {len(mutants)} places in all, seed {arguments.seed}")
    return 0 if noticed >= LEAST * tried else 1


if __name__ == "__main__":
    sys.exit(main())
