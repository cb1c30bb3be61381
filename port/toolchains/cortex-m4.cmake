# Cortex-M4 with its floating-point unit (STM32F4, nRF52): the ABI is the firmware's, roomseg uses
# none.
set(CMAKE_SYSTEM_PROCESSOR cortex-m4)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-mthumb -mcpu=cortex-m4 -mfloat-abi=hard -mfpu=fpv4-sp-d16")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
