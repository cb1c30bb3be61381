# Cortex-M4 without the floating-point unit.
set(CMAKE_SYSTEM_PROCESSOR cortex-m4-soft)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m4 -mfloat-abi=soft")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
