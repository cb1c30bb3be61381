# Shared by the toolchain files for targets without an operating system. They set, before they
# include it:
#   prefix   of the GNU tools, e.g. arm-none-eabi
#   cpu      the compiler's flags for the CPU, understood by GCC and Clang
#
# Variables for whoever configures:
#   ROOMSEG_LIBC    none (default): freestanding, nothing is linked but libgcc;
#                   newlib (Arm) or picolibc (RISC-V): the C library with semihosting
#   ROOMSEG_CLANG   ON: Clang compiles, the GNU tools link
set(CMAKE_SYSTEM_NAME Generic)
# Programs cannot be linked before a linker script is known.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(ROOMSEG_LIBC none CACHE STRING "none, newlib (Arm), picolibc (RISC-V)")
set(ROOMSEG_CLANG OFF CACHE BOOL "Compile with Clang instead of GCC")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES ROOMSEG_LIBC ROOMSEG_CLANG)

# There is no desk to run these on.
set(ROOMSEG_BUILD_TOOLS OFF CACHE BOOL "")
set(ROOMSEG_BUILD_TESTS OFF CACHE BOOL "")
if(NOT DEFINED CACHE{CMAKE_BUILD_TYPE})
    set(CMAKE_BUILD_TYPE MinSizeRel CACHE STRING "")
endif()

if(ROOMSEG_CLANG)
    set(CMAKE_C_COMPILER clang)
    set(CMAKE_C_COMPILER_TARGET ${clang_target})
    # Clang's own drivers for these targets look for a sysroot that Debian does not have.
    set(CMAKE_C_LINK_EXECUTABLE
        "${prefix}-gcc ${cpu} <LINK_FLAGS> <OBJECTS> -o <TARGET> <LINK_LIBRARIES>")
else()
    set(CMAKE_C_COMPILER ${prefix}-gcc)
endif()
set(CMAKE_ASM_COMPILER ${prefix}-gcc)
set(CMAKE_AR ${prefix}-ar CACHE FILEPATH "")
set(CMAKE_RANLIB ${prefix}-ranlib CACHE FILEPATH "")
set(CMAKE_NM ${prefix}-nm CACHE FILEPATH "")
set(CMAKE_SIZE ${prefix}-size CACHE FILEPATH "")

# A section a function, so that the linker can drop what a program does not reach.
set(flags "${cpu} -ffunction-sections -fdata-sections")
if(ROOMSEG_LIBC STREQUAL "none")
    string(APPEND flags " -ffreestanding -isystem ${CMAKE_CURRENT_LIST_DIR}/../baremetal/include")
    set(link "-nostdlib")
elseif(ROOMSEG_LIBC STREQUAL "newlib")
    set(link "--specs=rdimon.specs")
elseif(ROOMSEG_LIBC STREQUAL "picolibc")
    string(APPEND flags " --specs=picolibc.specs")
    set(link "--oslib=semihost") # the linker gets the compiler's flags too
else()
    message(FATAL_ERROR "ROOMSEG_LIBC=${ROOMSEG_LIBC} is none of none, newlib, picolibc")
endif()
set(CMAKE_C_FLAGS_INIT "${flags}")
set(CMAKE_ASM_FLAGS_INIT "${cpu}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostartfiles ${link} -Wl,--gc-sections")
# libgcc: the helpers for what a CPU cannot do, e.g. division on the Cortex-M0+.
set(CMAKE_C_STANDARD_LIBRARIES "-lgcc")

set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
