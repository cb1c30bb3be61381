# Cortex-M55 with the M-profile vector extension.
set(CMAKE_SYSTEM_PROCESSOR cortex-m55)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m55 -mfloat-abi=hard")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
