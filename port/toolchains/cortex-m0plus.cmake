# Cortex-M0+: no divider, no unaligned access, no floating point.
set(CMAKE_SYSTEM_PROCESSOR cortex-m0plus)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m0plus")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
