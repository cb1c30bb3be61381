// The maps on which each stage is held against OpenCV, and the way between the library's
// bordered buffers and OpenCV's matrices.
#ifndef OPENCV_MAPS_H
#define OPENCV_MAPS_H

#include <opencv2/core.hpp>

#include <string>
#include <vector>

extern "C" {
#include "base.h"
#include "watershed.h"
}

struct test_map {
    std::string name;
    cv::Mat cells;       // 8 bit, the whole grid
    roomseg_grid grid;   // shares the cells
    rs_frame frame;      // the crop
};

// Two simulated flats and, when there is a data set, real maps of each kind. Ends the program
// with a message when one cannot be made or read.
std::vector<test_map> load_maps(const char *data_set);

// The map turned by an angle, clockwise to the eye; nearest cells, unknown around.
test_map turned_map(const test_map &map, double degrees);

// The crop as the grid has it.
cv::Mat crop_of(const test_map &map);

// Free cells (255) and obstacles (0) of the crop, as OpenCV's threshold sees them.
cv::Mat free_cells(const test_map &map);

// A bordered buffer with 1 where the matrix is not 0, and back: the values of the crop.
std::vector<uint8_t> bordered(const rs_frame &frame, const cv::Mat &mask);
cv::Mat unbordered(const rs_frame &frame, const std::vector<uint8_t> &buffer);

// The matrix with `margin` rows and columns of 0 around it: what lies outside of a crop is an
// obstacle.
cv::Mat widened(const cv::Mat &crop, int margin);

// Cells in which two 8-bit matrices differ.
long differences(const cv::Mat &a, const cv::Mat &b);

#endif
