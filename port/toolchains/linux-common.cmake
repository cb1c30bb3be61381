# Shared by the toolchain files for Linux on other CPUs, whose programs qemu-user runs here. They
# set, before they include it: triple, of the GNU tools; emulator, the program of qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_C_COMPILER ${triple}-gcc)
# Static, so that the emulator needs no folder with the target's libraries.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_CROSSCOMPILING_EMULATOR ${emulator})
# Tools run here; headers without a library (stb) are this machine's too.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
