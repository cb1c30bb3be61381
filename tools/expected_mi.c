#include "expected_mi.h"

#include <math.h>

/* Terms below this share of the likeliest one cannot move the sum's last digit. */
static const double NEGLIGIBLE = 1e-20;

/* The overlap of a part of `a` cells with one of `b` among `total`, as doubles. */
typedef struct deal {
    double a, b, total;
} deal;

/* Running sums over n: of weights, and of n log(total n / (a b)) times weight. */
typedef struct moments {
    double weight, information;
} moments;

static void add_term(const deal *d, double n, double weight, moments *sum) {
    sum->weight += weight;
    if (n > 0.0) {
        sum->information += weight * n * log(d->total * n / (d->a * d->b));
    }
}

/* P(n + 1) / P(n), from the quotient of the binomials. */
static double step_up(const deal *d, double n) {
    return (d->a - n) * (d->b - n) / ((n + 1.0) * (d->total - d->a - d->b + n + 1.0));
}

/* E[n log(total n / (a b))]. The weights start at 1 in the likeliest n and follow from
 * each other, so that no factorial is needed and their sum normalises them. */
static double mean_information(const deal *d) {
    double low = fmax(0.0, d->a + d->b - d->total);
    double high = fmin(d->a, d->b);
    double mode = floor((d->a + 1.0) * (d->b + 1.0) / (d->total + 2.0));
    mode = fmin(fmax(mode, low), high);
    moments sum = {0.0, 0.0};
    double weight = 1.0;
    for (double n = mode; n <= high && weight > NEGLIGIBLE; n += 1.0) {
        add_term(d, n, weight, &sum);
        weight *= step_up(d, n);
    }
    weight = 1.0;
    for (double n = mode; n > low && weight > NEGLIGIBLE; n -= 1.0) {
        weight /= step_up(d, n - 1.0);
        add_term(d, n - 1.0, weight, &sum);
    }
    return sum.information / sum.weight;
}

double expected_mutual_information(const uint64_t *a, size_t a_count, const uint64_t *b,
                                   size_t b_count, uint64_t total) {
    double sum = 0.0;
    for (size_t i = 0; i < a_count; i++) {
        for (size_t j = 0; j < b_count; j++) {
            deal d = {(double)a[i], (double)b[j], (double)total};
            sum += mean_information(&d);
        }
    }
    return sum / (double)total;
}
