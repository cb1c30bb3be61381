# Cortex-M33 (STM32L5, nRF53, RP2350).
set(CMAKE_SYSTEM_PROCESSOR cortex-m33)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m33 -mfloat-abi=hard -mfpu=fpv5-sp-d16")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
