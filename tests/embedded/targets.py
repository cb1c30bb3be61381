"""The emulated machines: which toolchain file, which emulator, where their memories lie."""

from dataclasses import dataclass

K = 1024
M = 1024 * K


@dataclass(frozen=True)
class Target:
    name: str
    toolchain: str  # port/toolchains/NAME.cmake
    emulator: tuple  # command line, without the program
    memory: dict  # symbols of the linker script
    prefix: str  # of the GNU tools
    libc: str  # the C library that Debian has for it
    note: str = ""
    bare: bool = True  # without operating system

    @property
    def symbols(self):
        return [f"{name}={value:#x}" for name, value in self.memory.items()]


def memory(ram, ram_length, flash=None, flash_length=1 * M, maps=None, maps_length=3 * M):
    """Where the machines of 4 MB flash have it, the maps fill what the code leaves."""
    areas = {"ram_origin": ram, "ram_length": ram_length, "stack_length": 8 * K}
    if flash is not None:
        maps = flash + flash_length if maps is None else maps
        areas |= {"flash_origin": flash, "flash_length": flash_length,
                  "maps_origin": maps, "maps_length": maps_length}
    return areas


def cortex_m(name, toolchain, machine, areas, note=""):
    emulator = ("qemu-system-arm", "-M", machine)
    return Target(name, toolchain, emulator, areas, "arm-none-eabi-", "newlib", note)


def cortex_a(name, toolchain):
    # -nic none: its network card would want a boot ROM that Debian packs elsewhere.
    emulator = ("qemu-system-arm", "-M", "virt", "-cpu", "cortex-a7", "-m", "128M", "-nic", "none")
    return Target(name, toolchain, emulator, memory(0x40010000, 64 * M), "arm-none-eabi-",
                  "newlib")


def risc_v(name, toolchain, bits):
    emulator = (f"qemu-system-riscv{bits}", "-M", "virt", "-m", "64M", "-bios", "none")
    return Target(name, toolchain, emulator, memory(0x80000000, 48 * M), "riscv64-unknown-elf-",
                  "picolibc")


TARGETS = {target.name: target for target in (
    # No machine of QEMU with an ARMv6-M has the memory for a home; an ARMv7-M executes its
    # instructions just so, and as many of them.
    cortex_m("m0plus", "cortex-m0plus", "mps2-an385", memory(0x21000000, 16 * M, 0x0),
             "code for the Cortex-M0+ on a Cortex-M3"),
    cortex_m("m3", "cortex-m3", "mps2-an385", memory(0x21000000, 16 * M, 0x0)),
    cortex_m("m4", "cortex-m4", "mps2-an386", memory(0x21000000, 16 * M, 0x0)),
    cortex_m("m4-soft", "cortex-m4-soft", "mps2-an386", memory(0x21000000, 16 * M, 0x0)),
    cortex_m("m4-192k", "cortex-m4", "netduinoplus2",
             memory(0x20000000, 192 * K, 0x08000000, 256 * K, maps_length=768 * K),
             "192 KB of RAM: the maps that fit"),
    cortex_m("m7", "cortex-m7", "mps2-an500", memory(0x60000000, 16 * M, 0x0)),
    cortex_m("m33", "cortex-m33", "mps2-an505", memory(0x80000000, 16 * M, 0x10000000)),
    cortex_m("m55", "cortex-m55", "mps3-an547",
             memory(0x60800000, 64 * M, 0x0, 512 * K, maps=0x60000000, maps_length=8 * M)),
    cortex_a("a7", "cortex-a7"),
    cortex_a("a7-soft", "cortex-a7-soft"),
    risc_v("rv32", "rv32imac", 32),
    risc_v("rv64", "rv64imac", 64),
)}

# The home in 512 KB of RAM, its map included.
HOME_TARGET = cortex_m("m4-512k", "cortex-m4", "mps2-an386",
                       memory(0x21000000, 512 * K, 0x0) | {"stack_length": 1 * K})



def linux(cpu, emulator, prefix, note):
    return Target(f"linux-{cpu}", f"linux-{cpu}", (emulator,), {}, prefix, "none", note, False)


# Linux on other CPUs, whose programs qemu-user runs.
HOSTED = {target.name: target for target in (
    linux("armhf", "qemu-arm", "arm-linux-gnueabihf-", "32 bits, Arm"),
    linux("aarch64", "qemu-aarch64", "aarch64-linux-gnu-", "64 bits, Arm"),
    linux("s390x", "qemu-s390x", "s390x-linux-gnu-", "64 bits, big-endian"),
)}
