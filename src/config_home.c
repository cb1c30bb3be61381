/* In a file of its own: it names the aligner, which a program that never calls it must not
 * link. */
#include "roomseg/roomseg.h"

roomseg_config roomseg_config_paper_home(void)
{
    roomseg_config config = roomseg_config_paper();

    config.align = ROOMSEG_ALIGN_ON;
    config.speck_mm2 = 4000000; /* 2500 cells of 40 mm */
    return config;
}
