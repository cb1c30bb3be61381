// What the example sketch needs of Arduino, on a desk.
#pragma once
#include <stdint.h>
#include <stdio.h>

struct SerialPort {
  void begin(unsigned long) {}
  void println(const char *text) { puts(text); }
  void println(unsigned long value) { printf("%lu\n", value); }
  void println(unsigned value) { printf("%u\n", value); }
};
extern SerialPort Serial;
