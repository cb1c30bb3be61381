// Counted checks with the measured number beside the bound.
#ifndef OPENCV_CHECK_H
#define OPENCV_CHECK_H

#include <string>

// A check of a measured value against its bound; printed, counted.
void check_at_most(const std::string &map, const std::string &what, double value, double bound);
void check_at_least(const std::string &map, const std::string &what, double value, double bound);

// A count of differences that must be 0.
void check_same(const std::string &map, const std::string &what, long differences);

// How many checks failed; prints the sum of all.
int check_summary();

#endif
