# Cortex-M7 (STM32F7, STM32H7, i.MX RT).
set(CMAKE_SYSTEM_PROCESSOR cortex-m7)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m7 -mfloat-abi=hard -mfpu=fpv5-d16")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
