"""Builds the test programs and runs them, here and in emulators."""

import pathlib
import re
import subprocess
import sys

from targets import HOSTED, TARGETS

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "build" / "embedded"

# Maps of the optional data set, which the tests take when it is there.
DATASET_MAPS = ("neato/01.png", "neato/05.png", "neato/10.png", "furnished/13_office_b.png")
SMALL_FLASH = {"m4-192k"}  # get the small maps alone


class Failure(Exception):
    """What went wrong, in one line."""


def command(arguments, log=None, timeout=900):
    """Runs a command. Its output comes back; after an error the end of it is shown."""
    arguments = [str(argument) for argument in arguments]
    try:
        done = subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, timeout=timeout, check=False)
    except FileNotFoundError:
        raise Failure(f"{arguments[0]} is missing: run tools/setup.sh embedded") from None
    except subprocess.TimeoutExpired:
        raise Failure(f"{arguments[0]} did not end within {timeout} s") from None
    text = done.stdout.decode("utf-8", "replace")
    if log is not None:
        log.write_text(text)
    if done.returncode != 0:
        wrong = [line for line in text.splitlines() if "error" in line or "failed" in line]
        print("\n".join(wrong[:20] or [text[-2000:]]), file=sys.stderr)
        raise Failure(f"{' '.join(arguments[:6])} ... ended with {done.returncode}")
    return text


def default_dataset():
    """The folder of real maps, where it lies beside the checkout; None: there is none."""
    folder = ROOT.parent / "shared" / "benchmark"
    return folder if folder.is_dir() else None


class Host:
    """What this machine makes: the maps as C, and what the library finds in them."""

    def __init__(self, dataset, jobs):
        self.jobs = jobs
        self.build = WORK / "host"
        self.build.mkdir(parents=True, exist_ok=True)
        self.configure()
        self.make("make_maps")
        images = [dataset / name for name in DATASET_MAPS] if dataset else []
        images = [image for image in images if image.is_file()]
        self.maps = self.write_maps("maps.c", "--home", "--golden", "--small", "--patterns",
                                    *images)
        self.small_maps = self.write_maps("small_maps.c", "--small")
        self.configure(f"-DMAPS={self.maps}")
        self.make("program")
        self.text = command([self.build / "program"])
        self.runs = split_runs(self.text)

    def configure(self, *more):
        command(["cmake", "-S", HERE, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release", *more],
                self.build / "configure.log")

    def make(self, target):
        command(["cmake", "--build", self.build, "--target", target, "-j", self.jobs],
                self.build / "build.log")

    def write_maps(self, name, *arguments):
        """Leaves the file untouched when it is the same, so that nothing is built again."""
        file, fresh = self.build / name, self.build / "fresh.c"
        command([self.build / "make_maps", fresh, *arguments])
        if not file.is_file() or file.read_bytes() != fresh.read_bytes():
            fresh.replace(file)
        return file

    def maps_of(self, target):
        return self.small_maps if target.name in SMALL_FLASH else self.maps


class Build:
    """A target's programs, with one compiler, level of optimisation and C library."""

    def __init__(self, host, target, optimise="-Os", clang=False, libc="none", flags=""):
        compiler = "clang" if clang else "gcc"
        self.host, self.target, self.libc = host, target, libc
        self.title = f"{target.name} {compiler} {optimise}" + ("" if libc == "none" else f" {libc}")
        self.folder = WORK / (self.title.replace(" ", "_") + ("_budget" if flags else ""))
        self.folder.mkdir(parents=True, exist_ok=True)
        toolchain = ROOT / "port" / "toolchains" / (target.toolchain + ".cmake")
        command(["cmake", "-S", HERE, "-B", self.folder, f"-DCMAKE_TOOLCHAIN_FILE={toolchain}",
                 "-DCMAKE_BUILD_TYPE=None", f"-DCMAKE_C_FLAGS_NONE={optimise} {flags}",
                 f"-DROOMSEG_CLANG={'ON' if clang else 'OFF'}", f"-DROOMSEG_LIBC={libc}",
                 "-DROOMSEG_WERROR=ON", f"-DMAPS={host.maps_of(target)}",
                 f"-DLINK_SYMBOLS={';'.join(target.symbols)}"],
                self.folder / "configure.log")

    def make(self, program):
        command(["cmake", "--build", self.folder, "--target", program, "-j", self.host.jobs],
                self.folder / "build.log")
        return self.folder / program

    def run(self, program="program", more=(), timeout=600):
        file = self.make(program)
        log = self.folder / f"{program}.txt"
        if not self.target.bare:
            return command([*self.target.emulator, file], log, timeout)
        return command([*self.target.emulator, "-display", "none", "-monitor", "none",
                        "-serial", "none", "-chardev", "stdio,id=out", "-semihosting-config",
                        "enable=on,target=native,chardev=out", *more, "-kernel", file],
                       log, timeout)


def split_runs(text):
    """{(map, variant): (text that must be equal everywhere, measurements)} of a program."""
    runs, key = {}, None
    for line in text.splitlines():
        words = line.split()
        if line.startswith("run "):
            key = (words[1], words[2])
            runs[key] = ([line], {})
        elif line.startswith("failed "):
            raise Failure(line)
        elif line.startswith("# ") and key is not None and not line.startswith("# too"):
            runs[key][1].update(zip(words[1::2], words[2::2]))
        elif line.startswith(" ") and key is not None:
            runs[key][0].append(line)
    if not text.rstrip().endswith("end failures 0"):
        raise Failure("the program did not come to its end")
    return {key: ("\n".join(lines), values) for key, (lines, values) in runs.items()}


def label_crc(text):
    return re.search(r" labels (\w+) ", text)[1]


def select(names):
    known = {**TARGETS, **HOSTED}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise Failure(f"no target {unknown[0]}; there are {', '.join(known)}")
    return [known[name] for name in names]
