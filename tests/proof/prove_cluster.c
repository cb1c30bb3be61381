#include "../../src/cluster.c"
#include "proof.h"

/* Any four unions of four regions on a ring of four edges: the roots' lists stay circular, lead to
 * other roots only, and areas add up. */
void prove_cluster(void)
{
    enum { REGIONS = 4, EDGES = 4 };
    rs_region regions[REGIONS + 1u] = {{0}};
    rs_edge edges[EDGES] = {{0}};
    rs_graph graph = {regions, edges, REGIONS, EDGES};
    uint32_t total = 0, found = 0;
    for (uint16_t r = 1; r <= REGIONS; r++) {
        regions[r].area = nondet_u16();
        regions[r].parent = r;
        /* Region r stands at the ends 2 (r - 1) and 2 (r - 2) + 1 of the ring. */
        uint32_t out = 2u * (r - 1u), in = 2u * ((r + EDGES - 2u) % EDGES) + 1u;
        regions[r].first_half = out;
        edges[out >> 1].a = r;
        edges[in >> 1].b = r;
        edges[out >> 1].next[0] = in;
        edges[in >> 1].next[1] = out;
        total += regions[r].area;
    }
    for (uint32_t k = 0; k < 3u; k++) {
        uint16_t a = nondet_u8(), b = nondet_u8();
        ASSUME(a >= 1u && a <= REGIONS && b >= 1u && b <= REGIONS);
        a = rs_cluster_root(regions, a);
        b = rs_cluster_root(regions, b);
        if (a != b) {
            uint16_t root = rs_cluster_unite(&graph, a, b);
            uint32_t half = rs_cluster_first(&graph, root);
            PROVE(half == RS_NO_HALF ||
                  rs_cluster_root(regions, rs_graph_other_end(&graph, half)) != root);
        }
    }
    for (uint16_t r = 1; r <= REGIONS; r++) {
        found += regions[r].parent == r ? regions[r].area : 0u;
    }
    PROVE(found == total);
}
