#!/usr/bin/env python3
"""Checks the packages of port/ as far as a desk can.

    port/check.py          builds each with stand-ins for the other side (port/stand_in) and runs
                           what comes out; needs a compiler and CMake alone
    port/check.py --all    also lets the others' own tools at them: Conan, PlatformIO, Kconfiglib,
                           pykwalify, the ESP-IDF component manager, installed from PyPI into
                           build/port/venv; and arduino-builder, which is a package of Debian's

Exit: 0 all good, 1 not."""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PORT = ROOT / "port"
STAND_IN = PORT / "stand_in"
WORK = ROOT / "build" / "port"
EXAMPLE = ROOT / "examples" / "firmware.c"

TOOLS = ("conan==2.34.0", "platformio==6.2.0", "scons==4.8.1", "kconfiglib==14.1.0",
         "pykwalify==1.8.0", "idf-component-manager==3.1.2")
TWO_ROOMS = r"^room 1: \d+ cm2, centre \d+, \d+\nroom 2: .*\n$"
THREE_LINES = r"^done\n\d+\n\d+\n$"
WARNINGS = ("-Wall", "-Wextra", "-Werror")


class Failure(Exception):
    """What went wrong, in one line."""


class Skipped(Exception):
    """Why it cannot be done here."""


def command(*arguments, cwd=None, env=None):
    """Runs a command; what it wrote comes back."""
    arguments = [str(argument) for argument in arguments]
    try:
        done = subprocess.run(arguments, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, timeout=900, check=False, cwd=cwd,
                              env={**os.environ, **(env or {})})
    except FileNotFoundError:
        raise Failure(f"{arguments[0]} is missing") from None
    text = done.stdout.decode("utf-8", "replace")
    if done.returncode != 0:
        print(text[-3000:], file=sys.stderr)
        raise Failure(f"{' '.join(arguments[:5])} ... ended with {done.returncode}")
    return text


def expect(pattern, text, what):
    if not re.search(pattern, text, re.S):
        raise Failure(f"{what} wrote:\n{text}")


def fresh(name):
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def pack(kind, folder):
    command(PORT / "pack.sh", kind, folder)
    return folder / "roomseg"


def build_and_run(source, folder, *options):
    """A CMake project whose program is `firmware`, the README's example."""
    command("cmake", "-S", source, "-B", folder, f"-DEXAMPLE={EXAMPLE}", *options)
    command("cmake", "--build", folder, "-j", os.cpu_count())
    expect(TWO_ROOMS, command(folder / "firmware"), "examples/firmware.c")


def version():
    header = (ROOT / "include" / "roomseg" / "roomseg.h").read_text()
    return ".".join(re.findall(r"#define ROOMSEG_VERSION_\w+ (\d+)", header))


def manifests():
    """All manifests name the version of the header."""
    for file in ("platformio/library.json", "arduino/library.properties",
                 "vcpkg/roomseg/vcpkg.json", "esp-idf/roomseg/idf_component.yml"):
        found = re.search(r'version"?\s*[=:]\s*"?([\d.]+)', (PORT / file).read_text())
        if not found or found[1] != version():
            raise Failure(f"port/{file} is not of version {version()}")
    for file in ("platformio/library.json", "vcpkg/roomseg/vcpkg.json"):
        json.loads((PORT / file).read_text())
    return f"version {version()} in each"


def zephyr():
    module = (ROOT / "zephyr" / "module.yml").read_text()
    folder = ROOT / re.search(r"^  cmake: (\S+)$", module, re.M)[1]
    kconfig = ROOT / re.search(r"^  kconfig: (\S+)$", module, re.M)[1]
    if not kconfig.is_file():
        raise Failure(f"zephyr/module.yml: no {kconfig}")
    build_and_run(STAND_IN / "zephyr", fresh("zephyr"), f"-DMODULE={folder}", "-DCONFIG_ROOMSEG=y",
                  "-DCONFIG_ROOMSEG_OPTIMISE_SPEED=y")
    return "built with stand-ins for Zephyr's CMake functions, and run"


def esp_idf():
    folder = fresh("esp-idf")
    for component in (PORT / "esp-idf" / "roomseg", pack("esp-idf", folder / "packed")):
        build_and_run(STAND_IN / "esp-idf", folder / "build", f"-DCOMPONENT={component}")
        shutil.rmtree(folder / "build")
    return "built with a stand-in for ESP-IDF's CMake function, in place and packed, and run"


def arduino():
    """As Arduino builds a library: every file below src by itself, with src in the path."""
    folder = fresh("arduino")
    library = pack("arduino", folder)
    headers = [header.name for header in (library / "src").glob("*.h")]
    if headers != ["roomseg.h"]:
        raise Failure(f"Arduino would find the library by {', '.join(headers)}")
    objects = []
    for source in sorted((library / "src").glob("**/*.c")):
        objects.append(folder / f"{source.stem}.o")
        command("cc", "-std=gnu11", "-Os", *WARNINGS, "-I", library / "src", "-c", source,
                "-o", objects[-1])
    command("c++", "-std=gnu++11", *WARNINGS, "-I", library / "src", "-I", STAND_IN / "arduino",
            "-include", "Arduino.h", STAND_IN / "arduino" / "main.cpp",
            "-x", "c++", library / "examples" / "Rooms" / "Rooms.ino", "-x", "none", *objects,
            "-o", folder / "sketch")
    expect(THREE_LINES, command(folder / "sketch"), "the example sketch")
    return "compiled as Arduino compiles libraries; the sketch run with a stand-in for its core"


def freertos():
    folder = fresh("freertos")
    command("cc", "-std=c99", "-O2", *WARNINGS, "-D_POSIX_C_SOURCE=200809L", "-I",
            ROOT / "include", "-I", STAND_IN / "freertos", "-I", PORT / "freertos",
            PORT / "freertos" / "segment_task.c", STAND_IN / "freertos" / "main.c",
            *sorted((ROOT / "src").glob("*.c")), "-pthread", "-o", folder / "task")
    expect(r"^0: 2 rooms, watchdog fed: yes\n-10 after a cancel\n$", command(folder / "task"),
           "the example task")
    return "the task run and cancelled on a stand-in for the kernel"


def vcpkg():
    folder = fresh("vcpkg")
    command("cmake", f"-DPORT_DIR={PORT / 'vcpkg' / 'roomseg'}",
            f"-DCURRENT_BUILDTREES_DIR={folder / 'build'}",
            f"-DCURRENT_PACKAGES_DIR={folder / 'package'}", "-P", STAND_IN / "vcpkg.cmake")
    build_and_run(ROOT / "tests" / "package" / "consumer", folder / "consumer",
                  f"-DCMAKE_PREFIX_PATH={folder / 'package'}")
    return "portfile run with stand-ins for vcpkg's functions, the package used"


def install_tools():
    venv = WORK / "venv"
    if not (venv / "bin" / "compote").exists():
        command(sys.executable, "-m", "venv", venv)
        command(venv / "bin" / "pip", "install", "--quiet", "--disable-pip-version-check", *TOOLS)
    return venv / "bin"


def kconfig_by_kconfiglib(tools):
    program = ("import sys, kconfiglib\n"
               "kconfig = kconfiglib.Kconfig(sys.argv[1], warn_to_stderr=False)\n"
               "kconfig.syms['ROOMSEG'].set_value('y')\n"
               "kconfig.syms['ROOMSEG_OPTIMISE_SPEED'].set_value('y')\n"
               "print([s.str_value for s in kconfig.unique_defined_syms], kconfig.warnings)\n")
    text = command(tools / "python", "-c", program, PORT / "zephyr" / "Kconfig")
    expect(r"^\['y', 'n', 'y'\] \[\]$", text.strip(), "kconfiglib")
    return "Kconfig read by Kconfiglib, as Zephyr does"


def module_by_pykwalify(tools):
    folder = fresh("pykwalify")
    # What Zephyr asks of the keys that are used here (zephyr/module.yml in its documentation).
    (folder / "schema.yml").write_text("type: map\nmapping:\n"
                                       "  name: {type: str}\n"
                                       "  build:\n    type: map\n    mapping:\n"
                                       "      cmake: {type: str}\n      kconfig: {type: str}\n")
    command(tools / "pykwalify", "-d", ROOT / "zephyr" / "module.yml", "-s", folder / "schema.yml")
    return "module.yml valid by pykwalify, as Zephyr checks it"


def component_by_compote(tools):
    folder = fresh("compote")
    packed = pack("esp-idf", folder)
    command(tools / "compote", "component", "pack", "--name", "roomseg", cwd=packed)
    if not list(packed.glob("dist/roomseg_*.tgz")):
        raise Failure("the component manager made no archive")
    return "packed by ESP-IDF's component manager"


def package_by_conan(tools):
    folder = fresh("conan")
    env = {"CONAN_HOME": str(folder / "home")}
    command(tools / "conan", "profile", "detect", env=env)
    command(tools / "conan", "create", PORT / "conan", env=env)
    command(tools / "conan", "install", f"--requires=roomseg/{version()}", "-g", "CMakeDeps",
            "-of", folder / "found", env=env)
    build_and_run(ROOT / "tests" / "package" / "consumer", folder / "consumer",
                  f"-DCMAKE_PREFIX_PATH={folder / 'found'}", "-DCMAKE_BUILD_TYPE=Release")
    return "built and packaged by Conan, the package used"


def give_platformio_scons(tools, core):
    """PlatformIO would fetch SCons from its own registry; here it gets PyPI's."""
    wanted = command(tools / "python", "-c", "from platformio.dependencies import *\n"
                     "print(get_core_dependencies()['tool-scons'])").strip().lstrip("~")
    scons = core / "packages" / "tool-scons"
    scons.mkdir(parents=True)
    about = {"name": "tool-scons", "version": wanted}
    spec = {"owner": "platformio", "name": "tool-scons", "id": None, "requirements": None,
            "uri": None}
    (scons / "package.json").write_text(json.dumps({**about, "description": "SCons"}))
    (scons / ".piopm").write_text(json.dumps({"type": "tool", **about, "spec": spec}))
    (scons / "scons.py").write_text("import SCons.Script.Main\nSCons.Script.Main.main()\n")


def library_by_platformio(tools):
    folder = fresh("platformio")
    library = pack("platformio", folder)
    project = folder / "project"
    (project / "src").mkdir(parents=True)
    shutil.copy(EXAMPLE, project / "src" / "main.c")
    (project / "platformio.ini").write_text(
        f"[env:desk]\nplatform = symlink://{STAND_IN / 'platformio'}\n"
        f"lib_deps = symlink://{library}\n")
    give_platformio_scons(tools, folder / "core")
    env = {"PLATFORMIO_CORE_DIR": str(folder / "core"), "PATH": f"{tools}:{os.environ['PATH']}",
           "PLATFORMIO_SETTING_ENABLE_TELEMETRY": "No"}
    command(tools / "pio", "run", cwd=project, env=env)
    expect(TWO_ROOMS, command(project / ".pio" / "build" / "desk" / "program"), "the example")
    return "built by PlatformIO for a platform that is this machine, and run"


def library_by_arduino(_):
    """Arduino's own builder: how it finds the library, what it compiles and links."""
    if not shutil.which("arduino-builder"):
        raise Skipped("apt-get install arduino-builder")
    folder = fresh("arduino-builder")
    library = pack("arduino", folder / "libraries")
    platform = folder / "hardware" / "roomseg" / "desk"
    shutil.copytree(STAND_IN / "arduino" / "desk", platform)
    core = platform / "cores" / "desk"
    core.mkdir(parents=True)
    for name in ("Arduino.h", "main.cpp"):
        shutil.copy(STAND_IN / "arduino" / name, core)
    build = folder / "build"
    build.mkdir()
    command("arduino-builder", "-compile", "-hardware", "/usr/share/arduino-builder",
            "-hardware", folder / "hardware", "-tools", "/usr/bin",
            "-libraries", library.parent, "-fqbn", "roomseg:desk:desk", "-build-path", build,
            "-prefs", "build.warn_data_percentage=75",
            library / "examples" / "Rooms" / "Rooms.ino")
    expect(THREE_LINES, command(build / "sketch.out"), "the example sketch")
    return "built by Arduino's builder for a platform that is this machine, and run"


CHECKS = (manifests, zephyr, esp_idf, arduino, freertos, vcpkg)
TOOL_CHECKS = (kconfig_by_kconfiglib, module_by_pykwalify, component_by_compote, package_by_conan,
               library_by_platformio, library_by_arduino)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    checks = [(check, ()) for check in CHECKS]
    good = True
    try:
        if options.all:
            tools = install_tools()
            checks += [(check, (tools,)) for check in TOOL_CHECKS]
    except Failure as failure:
        print(f"check.py: PyPI: {failure}", file=sys.stderr)
        good = False
    for check, arguments in checks:
        try:
            print(f"good    {check.__name__}: {check(*arguments)}", flush=True)
        except Skipped as cause:
            print(f"skipped {check.__name__}: {cause}", flush=True)
        except Failure as failure:
            print(f"FAILED  {check.__name__}: {failure}", flush=True)
            good = False
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
