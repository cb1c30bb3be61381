#include "lidar.h"

#include "turn.h"

enum {
    MM_PER_STEP = 10,   /* the beam is followed in steps of one pixel */
    BLIND_MM = 120,     /* closer than this nothing is measured */
    GLASS_PASS = 220,   /* share of beams that pass glass [permille] */
    GLASS_BACK = 450,   /* share of the others that come back */
    DARK_BACK = 300,
    CRACK_SLIP = 100,
    SLIP_SHORT = 930,   /* share of slips that end soon [permille] */
    HAZE_BACK = 60,     /* for each cm on the way through */
    RUG_BACK = 1,
    SIGMA_BASE_MM = 3,  /* standard deviation of a range: base + permille of it */
    SIGMA_PERMILLE = 4
};

/* What became of the beam in this pixel. */
typedef enum fate { FATE_ON, FATE_BACK, FATE_LOST, FATE_SLIPPED } fate;

/* in_glass: the beam passes the pane that it is in. */
static fate meet(material m, int *in_glass, rng *r) {
    switch (m) {
    case MAT_RUG:
        return rng_chance(r, RUG_BACK) ? FATE_BACK : FATE_ON;
    case MAT_HAZE:
        return rng_chance(r, HAZE_BACK) ? FATE_BACK : FATE_ON;
    case MAT_GLASS:
        if (*in_glass || rng_chance(r, GLASS_PASS)) {
            *in_glass = 1;
            return FATE_ON;
        }
        return rng_chance(r, GLASS_BACK) ? FATE_BACK : FATE_LOST;
    case MAT_DARK:
        return rng_chance(r, DARK_BACK) ? FATE_BACK : FATE_LOST;
    case MAT_CRACK:
        return rng_chance(r, CRACK_SLIP) ? FATE_SLIPPED : FATE_BACK;
    case MAT_RIM:
        return FATE_LOST;
    default:
        return FATE_BACK;
    }
}

/* Length of the beam's way [mm], or 0 when it is lost. */
static int32_t follow(const world *w, position from, int32_t angle, rng *r) {
    int32_t dx = turn_cos(angle);
    int32_t dy = turn_sin(angle);
    position at = from;
    int in_glass = 0;
    for (int32_t range = 0; range < LIDAR_MAX_MM; range += MM_PER_STEP) {
        /* The rim keeps both coordinates from leaving the picture. */
        material m = world_material(w, at.x / 65536, at.y / 65536);
        if (m > MAT_OUTSIDE) {
            fate f = meet(m, &in_glass, r);
            if (f == FATE_SLIPPED) {
                int soon = rng_chance(r, SLIP_SHORT);
                return range + (soon ? rng_range(r, 60, 420) : rng_range(r, 300, 4500));
            }
            if (f != FATE_ON) {
                return f == FATE_BACK ? range : 0;
            }
        } else {
            in_glass = 0;
        }
        at.x += dx;
        at.y += dy;
    }
    return 0;
}

int32_t lidar_measure(const world *w, position from, int32_t angle, int noise, rng *r) {
    int32_t way = follow(w, from, angle, r);
    int lost = rng_chance(r, noise / 5);
    if (way < BLIND_MM || lost) {
        return 0;
    }
    /* The beam meets the pixel's near side, half a step earlier on average. */
    int32_t sigma = (SIGMA_BASE_MM * 1000 + way * SIGMA_PERMILLE) * noise / 50;
    int32_t range = way + rng_normal(r, sigma) / 1000;
    return range >= BLIND_MM && range <= LIDAR_MAX_MM + 4500 ? range : 0;
}
