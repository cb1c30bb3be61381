#!/usr/bin/env python3
"""Do the tests notice when the library is wrong?

    tests/mutate.py [--count N] [--seed S] [--list]

Changes one operator or constant of src/ at a time, N of all such places drawn by a seeded
generator, builds the stage, interface and limits tests with it and runs them until one fails. A
change that no test notices has survived and is printed. Works on a copy in build/mutate. Exit
code 1 when less than 90 % were noticed. A change that does not compile is not counted.
"""

import argparse
import pathlib
import random
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
WORK = ROOT / "build" / "mutate"
LEAST = 0.9
# Left out: what is long, and has nothing to say that the others have not.
TESTS = ["-L", "stage|api|limits", "-E", "limits_(cancel|two_threads)"]
SWAPS = {"<=": "<", ">=": ">", "<": "<=", ">": ">=", "==": "!=", "!=": "==", "&&": "||",
         "||": "&&", "+": "-", "-": "+", "*": "+", "/": "*", "<<": ">>", ">>": "<<", "&": "|"}
OPERATOR = re.compile(r"(?<=\s)(<=|>=|==|!=|&&|\|\||<<|>>|[-+*/<>&])(?=\s)")
CONSTANT = re.compile(r"(?<![\w.])(\d+)u?(?![\w.])")
COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


class Mutant:
    """One change: bytes start..end of a file become `text`."""

    def __init__(self, path: pathlib.Path, start: int, end: int, text: str):
        self.path, self.start, self.end, self.text = path, start, end, text

    def __str__(self) -> str:
        source = (ROOT / "src" / self.path).read_text(encoding="utf-8")
        line = source.count("\n", 0, self.start)
        return (f"{self.path}:{line + 1}: {source[self.start:self.end]} -> {self.text}: "
                f"{source.splitlines()[line].strip()}")


def find_mutants() -> list[Mutant]:
    mutants = []
    for path in sorted((ROOT / "src").glob("*.c")):
        source = path.read_text(encoding="utf-8")
        # Blank out comments, directives and asserts, so that positions stay.
        code = COMMENT.sub(lambda m: re.sub(r"\S", " ", m.group()), source)
        code = re.sub(r"^(#|RS_STATIC_ASSERT|const char).*(\\\n.*)*$",
                      lambda m: re.sub(r"[^\n]", " ", m.group()), code, flags=re.MULTILINE)
        for match in OPERATOR.finditer(code):
            mutants.append(Mutant(path.name, *match.span(1), SWAPS[match.group(1)]))
        for match in CONSTANT.finditer(code):
            mutants.append(Mutant(path.name, *match.span(1), str(int(match.group(1)) + 1)))
    return mutants


def prepare() -> None:
    shutil.rmtree(WORK, ignore_errors=True)
    shutil.copytree(ROOT, WORK / "copy",
                    ignore=shutil.ignore_patterns("build", ".git", "out"))
    configure = ["cmake", "-S", WORK / "copy", "-B", WORK / "build", "-DROOMSEG_BUILD_TOOLS=OFF",
                 "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_C_FLAGS_RELEASE=-O1"]
    if (ROOT / "build" / "unity").is_dir():
        configure.append(f"-DUNITY_DIR={ROOT / 'build' / 'unity'}")
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)


def run(command: list, seconds: int) -> bool:
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=seconds, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def build() -> bool:
    return run(["cmake", "--build", WORK / "build", "-j", "2"], 1200)


def tests_pass() -> bool:
    return run(["ctest", "--test-dir", WORK / "build", "-j", "2", "--stop-on-failure",
                "--timeout", "120", *TESTS], 1200)


def try_mutant(mutant: Mutant) -> str:
    path = WORK / "copy" / "src" / mutant.path
    source = path.read_text(encoding="utf-8")
    path.write_text(source[:mutant.start] + mutant.text + source[mutant.end:], encoding="utf-8")
    if not build():
        verdict = "invalid"
    else:
        verdict = "SURVIVED" if tests_pass() else "noticed"
    path.write_text(source, encoding="utf-8")
    return verdict


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true", help="only print the sample")
    arguments = parser.parse_args()
    mutants = find_mutants()
    sample = random.Random(arguments.seed).sample(mutants, min(arguments.count, len(mutants)))
    if arguments.list:
        print(*sample, sep="\n")
        return 0
    prepare()
    if not build() or not tests_pass():
        print("mutate: the tests fail without any change", file=sys.stderr)
        return 1
    counts = {"noticed": 0, "SURVIVED": 0, "invalid": 0}
    for mutant in sample:
        verdict = try_mutant(mutant)
        counts[verdict] += 1
        print(f"{verdict:9}{mutant}", flush=True)
    tried = counts["noticed"] + counts["SURVIVED"]
    print(f"{counts['noticed']} of {tried} noticed ({100.0 * counts['noticed'] / max(tried, 1):.1f}"
          f" %), {len(mutants)} places in all, seed {arguments.seed}")
    return 0 if counts["noticed"] >= LEAST * tried else 1


if __name__ == "__main__":
    sys.exit(main())
