// What the tests of several stages need.
#include "stages.h"

#include <opencv2/imgproc.hpp>

#include <cstring>

extern "C" {
#include "components.h"
#include "lifetime.h"
#include "plan.h"
#include "queue.h"
#include "watershed.h"
}

rs_ticker quiet()
{
    rs_ticker ticker;
    std::memset(&ticker, 0, sizeof ticker);
    return ticker;
}

cv::Mat cleared(const test_map &map)
{
    const int noise = 60; // cells
    cv::Mat obstacles = free_cells(map) == 0;
    cv::Mat labels, stats, centroids;
    int count = cv::connectedComponentsWithStats(widened(obstacles, 1), labels, stats, centroids,
                                                 8, CV_32S);
    cv::Mat out = free_cells(map);
    for (int y = 0; y < out.rows; y++) {
        for (int x = 0; x < out.cols; x++) {
            int label = labels.at<int>(y + 1, x + 1);
            if (label > 0 && label < count && stats.at<int>(label, cv::CC_STAT_AREA) < noise) {
                out.at<uint8_t>(y, x) = 255;
            }
        }
    }
    return out;
}

cv::Mat dilated(const test_map &map)
{
    cv::Mat obstacles = cleared(map) == 0;
    cv::Mat out;
    cv::dilate(obstacles, out, cv::Mat::ones(3, 3, CV_8U), cv::Point(-1, -1), 3,
               cv::BORDER_CONSTANT, 255);
    return out == 0;
}

rs_labels labels_of(cv::Mat &labels)
{
    return {labels.ptr<uint16_t>(), (uint32_t)(labels.step / sizeof(uint16_t))};
}

cv::Mat lifetime_of(const test_map &map, const cv::Mat &free, bool halve)
{
    const uint32_t mm = map.grid.resolution_mm;
    rs_lifetime_rules rules = {mm, mm, mm / 2u, 50, halve ? 3u << 4 : UINT32_MAX, 40};
    uint32_t rows = rs_lifetime_ring_rows(&rules);
    size_t width = map.frame.width + 2u * rules.margin;
    size_t height = map.frame.height + 2u * rules.margin;
    std::vector<uint16_t> shares(width * height), ring(width * rows);
    std::vector<uint32_t> sums(width), prefix(width + 2u * rows);
    rs_lifetime_scratch scratch = {shares.data(), {sums.data(), prefix.data(), ring.data(), rows}};
    std::vector<uint8_t> cells = bordered(map.frame, free);
    rs_ticker ticker = quiet();
    rs_lifetime_run(&map.frame, &rules, cells.data(), &scratch, &ticker);
    return unbordered(map.frame, cells);
}

cv::Mat regions_of(const test_map &map, const cv::Mat &surface, uint32_t *count)
{
    cv::Mat labels = cv::Mat::zeros(surface.size(), CV_16U);
    std::vector<uint8_t> heights(bordered(map.frame, surface));
    std::vector<uint32_t> cells((size_t)surface.total() / 8 + 16);
    rs_ring ring = {cells.data(), (uint32_t)cells.size(), 0, 0};
    rs_labels out = labels_of(labels);
    rs_ticker ticker = quiet();
    for (int y = 0; y < surface.rows; y++) {
        std::memcpy(&heights[rs_frame_index(&map.frame, 0, (uint32_t)y)], surface.ptr(y),
                    (size_t)surface.cols);
    }
    rs_watershed_run(&map.frame, heights.data(), ROOMSEG_MAX_REGIONS, &out, count, &ring, &ticker);
    return labels;
}
