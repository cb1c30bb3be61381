#!/usr/bin/env python3
"""Segments the same maps on emulated targets and here, and compares labels and rooms.

    tests/embedded/run.py              the core: one Cortex-M4, one Cortex-M7, one RV32, s390x
    tests/embedded/run.py --all        every target at -O0, -O2, -Os with GCC and Clang, with
                                       newlib or picolibc, the home in 512 KB, and the tests
                                       under qemu-user
    tests/embedded/run.py TARGET...    these targets at -O0, -O2, -Os with GCC and Clang
    tests/embedded/run.py --update     writes the checksums in README.md and docs/embedded.md
                                       anew; all other runs compare them

tools/setup.sh embedded installs what it needs. Exit: 0 all equal, 1 not, 2 wrong usage."""

import argparse
import os
import json
import pathlib
import re
import sys

import emulate
import tables
from emulate import Build, Failure, Host, WORK, command
from targets import HOME_TARGET, HOSTED, TARGETS

CORE = (("m4", "-Os", False, "none"), ("m7", "-O2", False, "none"),
        ("rv32", "-Os", False, "none"), ("m4", "-O2", True, "none"))
CORE_HOSTED = ("linux-s390x",)
LEVELS = ("-O0", "-O2", "-Os")
# Minutes in an emulator; only with --all.
TOO_LONG = re.compile("stage_(lifetime|ridge)$|limits_cancel$|real_|"
                      "tools_(explain_files|simulate)$")


def compare(title, runs, host_runs):
    """Prints a line; returns whether everything is equal."""
    different = [key for key, (text, _) in runs.items() if text != host_runs[key][0]]
    if not runs or different:
        name = " ".join(different[0]) if different else "no map was run"
        print(f"DIFFERENT  {title}: {name}", flush=True)
        return False
    print(f"equal      {title}: {len(runs)} runs", flush=True)
    return True


def emulated(host, target, optimise, clang, libc):
    build = Build(host, target, optimise, clang, libc)
    try:
        return compare(build.title, emulate.split_runs(build.run()), host.runs)
    except Failure as failure:
        print(f"FAILED     {build.title}: {failure}", flush=True)
        return False


def home(host):
    """The home with all of its memory in 512 KB. Its arena is smaller: fewer regions."""
    runs = emulate.split_runs(Build(host, HOME_TARGET).run("home"))
    text, numbers = runs[("home", "default")]
    equal = emulate.label_crc(text) == emulate.label_crc(host.runs[("home", "default")][0])
    total = sum(int(numbers[name]) for name in ("map", "labels", "arena", "stack"))
    detail = " + ".join(f"{name} {numbers[name]}" for name in ("map", "labels", "arena", "stack"))
    print(f"{'equal' if equal else 'DIFFERENT':10} home of 400 x 300 cells in 512 KB: "
          f"{total} bytes = {detail}", flush=True)
    return equal


def emulated_tests(folder, emulator):
    """Tests that CTest starts in the emulator. All others are scripts of this machine, which may
    run a program of the build, or look at files that it installs here."""
    listed = json.loads(command(["ctest", "--test-dir", folder, "--show-only=json-v1"]))
    return [test["name"] for test in listed["tests"]
            if pathlib.Path(test.get("command", [""])[0]).name == emulator]


def hosted(name, dataset, jobs, everything):
    """The project's tests on Linux for another CPU, under qemu-user."""
    folder = WORK / name
    folder.mkdir(parents=True, exist_ok=True)
    toolchain = emulate.ROOT / "port" / "toolchains" / (name + ".cmake")
    try:
        command(["cmake", "-S", emulate.ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                 f"-DCMAKE_TOOLCHAIN_FILE={toolchain}", "-DROOMSEG_WERROR=ON",
                 # This machine's OpenCV is of no use there.
                 "-DCMAKE_CXX_COMPILER=NOTFOUND", f"-DROOMSEG_BENCHMARK_DIR={dataset or ''}"],
                folder / "configure.log")
        command(["cmake", "--build", folder, "-j", jobs], folder / "build.log")
        names = [name for name in emulated_tests(folder, HOSTED[name].emulator[0])
                 if everything or not TOO_LONG.match(name)]
        if not names:
            raise Failure("there are no tests: tools/setup.sh embedded")
        text = command(["ctest", "--test-dir", folder, "-j", jobs, "--output-on-failure", "-R",
                        f"^({'|'.join(names)})$"], folder / "ctest.log", 3000)
    except Failure as failure:
        print(f"FAILED     {name}: {failure}", flush=True)
        return False
    summary = [line for line in text.splitlines() if "tests passed" in line]
    print(f"passed     {name} ({HOSTED[name].note}): {summary[0] if summary else '?'}", flush=True)
    return True


def run_target(host, target):
    """Everything that there is of one target."""
    good = True
    for level in LEVELS:
        for clang in (False, True) if target.bare else (False,):
            good &= emulated(host, target, level, clang, "none")
    if target.bare and target.name not in emulate.SMALL_FLASH:
        good &= emulated(host, target, "-Os", False, target.libc)
    return good


def run_core(host):
    good = True
    for name, level, clang, libc in CORE:
        good &= emulated(host, TARGETS[name], level, clang, libc)
    for name in CORE_HOSTED:
        good &= emulated(host, HOSTED[name], "-O2", False, "none")
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", metavar="TARGET")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--dataset", type=pathlib.Path, default=emulate.default_dataset(),
                        help="folder with the optional real maps")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    try:
        chosen = emulate.select(options.targets)
        host = Host(options.dataset, options.jobs)
        print(f"{len(host.runs)} runs here: {host.maps}", flush=True)
        good = tables.check(host.runs, (*TARGETS.values(), *HOSTED.values()), options.update)
        if options.update:
            return 0 if good else 1
        if chosen or options.all:
            for target in chosen or (*TARGETS.values(), *HOSTED.values()):
                good &= run_target(host, target)
        else:
            good &= run_core(host)
        if not chosen:
            good &= home(host)
            for name in HOSTED if options.all else CORE_HOSTED:
                good &= hosted(name, options.dataset, options.jobs, options.all)
    except Failure as failure:
        print(f"run.py: {failure}", file=sys.stderr)
        return 1
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
