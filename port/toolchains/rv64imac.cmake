# RISC-V, 64 bits, no floating point.
set(CMAKE_SYSTEM_PROCESSOR riscv64)
set(prefix riscv64-unknown-elf)
set(clang_target riscv64-unknown-elf)
set(cpu "-march=rv64imac -mabi=lp64 -mcmodel=medany")
include(${CMAKE_CURRENT_LIST_DIR}/none-common.cmake)
