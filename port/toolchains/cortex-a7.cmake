# Cortex-A7 with NEON, hard-float ABI. Unaligned accesses fault while the MMU is off.
set(CMAKE_SYSTEM_PROCESSOR cortex-a7)
set(prefix arm-none-eabi)
set(clang_target arm-none-eabi)
set(cpu "-marm -mcpu=cortex-a7 -mfpu=neon-vfpv4 -mfloat-abi=hard -mno-unaligned-access")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
