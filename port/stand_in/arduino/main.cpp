// A board's start-up on a desk: one round of the sketch.
#include "Arduino.h"

SerialPort Serial;
void setup();
void loop();

int main() {
  setup();
  loop();
  return 0;
}
