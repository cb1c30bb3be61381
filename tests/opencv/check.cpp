#include "check.h"

#include <cstdio>

static int count;
static int failed;

static void report(bool good, const std::string &map, const std::string &what, double value,
                   const char *relation, double bound)
{
    count++;
    failed += !good;
    std::printf("%s  %-28s %-48s %.6g (%s %g)\n", good ? "ok    " : "FAILED", map.c_str(),
                what.c_str(), value, relation, bound);
}

void check_at_most(const std::string &map, const std::string &what, double value, double bound)
{
    report(value <= bound, map, what, value, "at most", bound);
}

void check_at_least(const std::string &map, const std::string &what, double value, double bound)
{
    report(value >= bound, map, what, value, "at least", bound);
}

void check_same(const std::string &map, const std::string &what, long differences)
{
    report(differences == 0, map, what + ": cells that differ", (double)differences, "must be", 0);
}

int check_summary()
{
    std::printf("%d checks, %d failed\n", count, failed);
    return failed > 0 || count == 0;
}
