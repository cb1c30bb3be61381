# cmake -DSOURCE=DIR -P readme.cmake : the README holds examples/firmware.c word for word.
cmake_minimum_required(VERSION 3.16)
file(READ ${SOURCE}/README.md readme)
file(READ ${SOURCE}/examples/firmware.c example)
string(FIND "${readme}" "```c\n${example}```" at)
if(at EQUAL -1)
    message(FATAL_ERROR "README.md does not show examples/firmware.c as it is")
endif()
