# Cortex-M3.
set(CMAKE_SYSTEM_PROCESSOR cortex-m3)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m3")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
