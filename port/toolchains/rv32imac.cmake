# RISC-V, 32 bits (ESP32-C3 and -C6, CH32V3, GD32VF103): no floating point.
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(prefix riscv64-unknown-elf)
set(clang_target riscv32-unknown-elf)
set(cpu "-march=rv32imac -mabi=ilp32 -mcmodel=medany")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
