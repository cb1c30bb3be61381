#include "../../src/ring.h"
#include "proof.h"

/* A ring in any state, and one step: what the ring holds afterwards, cell by cell. As the state is
 * any, the same follows for any number of steps. */
enum { MOST = 9 };

static rs_ring any_ring(uint32_t *cells)
{
    rs_ring ring = {cells, nondet_u32(), nondet_u32(), nondet_u32()};
    ASSUME(ring.capacity >= 1u && ring.capacity <= MOST);
    ASSUME(ring.first < ring.capacity && ring.count <= ring.capacity);
    for (uint32_t i = 0; i < MOST; i++) {
        cells[i] = nondet_u32();
    }
    return ring;
}

/* Its i-th oldest cell, by the definition. */
static uint32_t held(const rs_ring *ring, uint32_t i)
{
    return ring->cells[(ring->first + i) % ring->capacity];
}

void prove_ring_push(void)
{
    uint32_t cells[MOST], cell = nondet_u32(), i = nondet_u32();
    rs_ring ring = any_ring(cells);
    uint32_t count = ring.count;
    ASSUME(i < count);
    uint32_t before = held(&ring, i);
    bool pushed = rs_ring_push(&ring, cell);
    PROVE(pushed == (count < ring.capacity) && ring.count == count + (pushed ? 1u : 0u));
    PROVE(ring.first < ring.capacity && ring.count <= ring.capacity);
    PROVE(held(&ring, i) == before);
    PROVE(!pushed || held(&ring, count) == cell);
}

void prove_ring_pop(void)
{
    uint32_t cells[MOST], i = nondet_u32();
    rs_ring ring = any_ring(cells);
    ASSUME(i < MOST && i + 1u < ring.count);
    uint32_t oldest = held(&ring, 0), before = held(&ring, i + 1u), count = ring.count;
    PROVE(rs_ring_pop(&ring) == oldest);
    PROVE(ring.first < ring.capacity && ring.count == count - 1u);
    PROVE(held(&ring, i) == before);
}
