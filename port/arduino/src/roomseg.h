/* The header by which Arduino finds the library: it looks at the top of src alone. */
#include "roomseg/roomseg.h"
