// One function a stage of the library; each checks it on one map.
#ifndef OPENCV_STAGES_H
#define OPENCV_STAGES_H

#include "maps.h"

void test_threshold(const test_map &map);
void test_components(const test_map &map);
void test_distance(const test_map &map);
void test_watershed(const test_map &map);
void test_morphology(const test_map &map);
void test_blur(const test_map &map);
void test_lifetime(const test_map &map);
void finish_lifetime();
void test_seeds(const test_map &map);
void test_ridge(const test_map &map);
void test_watershed_lines(const test_map &map);
void test_canny(const test_map &map);
void test_hough(const test_map &map);
void test_rotate(const test_map &map);

// What several of them need.

// Components that are noise cleared from the free cells of the crop: 255 free, 0 obstacle.
cv::Mat cleared(const test_map &map);

// Obstacles dilated by 3 x 3 three times, as the paper's system has them before the blur.
cv::Mat dilated(const test_map &map);

// Labels of the crop as 16-bit matrix and as the library takes them; they share memory.
rs_labels labels_of(cv::Mat &labels);

// The lifetime of each cell by the library, 8 bit. halve: with decimation.
cv::Mat lifetime_of(const test_map &map, const cv::Mat &free, bool halve);

// Regions of the library's watershed on a surface; *count of them.
cv::Mat regions_of(const test_map &map, const cv::Mat &surface, uint32_t *count);

// A ticker without hook.
rs_ticker quiet();

#endif
