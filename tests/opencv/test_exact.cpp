// Stages that must agree with OpenCV in every cell.
#include "check.h"
#include "stages.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <map>
#include <set>

extern "C" {
#include "components.h"
#include "distance.h"
#include "morphology.h"
#include "seeds.h"
#include "threshold.h"
}

void test_threshold(const test_map &map)
{
    std::vector<uint8_t> surface((size_t)map.frame.stride * (map.frame.height + 2u));
    rs_ticker ticker = quiet();
    rs_threshold_run(&map.grid, 51, &map.frame, surface.data(), &ticker);
    check_same(map.name, "threshold",
               differences(unbordered(map.frame, surface) * 255, free_cells(map)));
    cv::Mat all;
    cv::threshold(map.cells, all, 51, 255, cv::THRESH_BINARY_INV);
    cv::Rect box = cv::boundingRect(all);
    check_same(map.name, "crop", (box.x != (int)map.frame.x) + (box.y != (int)map.frame.y) +
                                     (box.width != (int)map.frame.width) +
                                     (box.height != (int)map.frame.height));
}

// Scratch of the components stage for a frame.
struct component_memory {
    std::vector<rs_run> runs;
    std::vector<rs_component> components;
    std::vector<uint16_t> active, vacant;
    std::vector<uint32_t> stack;
    rs_component_scratch scratch;

    component_memory(const rs_frame &frame)
        : runs(2u * ROOMSEG_PLAN_RUNS(frame.width)), components(runs.size()),
          active(runs.size()), vacant(runs.size()), stack((size_t)frame.width * frame.height)
    {
        scratch = {runs.data(), components.data(), active.data(), vacant.data(), stack.data()};
    }
};

// Obstacles that touch the border have no known size and stay.
static cv::Mat clear_small(const cv::Mat &free, int connectivity, int speck)
{
    cv::Mat labels, stats, centroids;
    cv::Mat obstacles = free == 0, whole;
    cv::copyMakeBorder(obstacles, whole, 1, 1, 1, 1, cv::BORDER_CONSTANT, 255);
    cv::connectedComponentsWithStats(whole, labels, stats, centroids, connectivity, CV_32S);
    int outside = labels.at<int>(0, 0);
    cv::Mat out = free.clone();
    for (int y = 0; y < out.rows; y++) {
        for (int x = 0; x < out.cols; x++) {
            int label = labels.at<int>(y + 1, x + 1);
            if (out.at<uint8_t>(y, x) == 0 && label != outside &&
                stats.at<int>(label, cv::CC_STAT_AREA) < speck) {
                out.at<uint8_t>(y, x) = 255;
            }
        }
    }
    return out;
}

static cv::Mat keep_large_free(const cv::Mat &free)
{
    cv::Mat labels, stats, centroids;
    int count = cv::connectedComponentsWithStats(free, labels, stats, centroids, 8, CV_32S);
    long total = cv::countNonZero(free);
    cv::Mat out = free.clone();
    for (int y = 0; y < out.rows; y++) {
        for (int x = 0; x < out.cols; x++) {
            int label = labels.at<int>(y, x);
            if (label > 0 && (long)stats.at<int>(label, cv::CC_STAT_AREA) * (count - 1) < total) {
                out.at<uint8_t>(y, x) = 0;
            }
        }
    }
    return out;
}

// Many islands of a few cells, so that some are just as large as the mean, or a cell smaller.
static void check_islands_of_noise(const std::string &name)
{
    const rs_frame frame = {0, 0, 24, 24, 26};
    component_memory memory(frame);
    rs_ticker ticker = quiet();
    cv::RNG random(name.size());
    cv::Mat noise(24, 24, CV_8U);
    long wrong = 0;
    for (int i = 0; i < 300; i++) {
        random.fill(noise, cv::RNG::UNIFORM, 0, 256);
        cv::Mat free = noise < 40 + i % 60;
        std::vector<uint8_t> surface = bordered(frame, free);
        rs_components_keep_large_free(&frame, surface.data(), &memory.scratch, &ticker);
        wrong += differences(unbordered(frame, surface) * 255, keep_large_free(free));
    }
    check_same(name, "free islands of noise", wrong);
}

void test_components(const test_map &map)
{
    component_memory memory(map.frame);
    rs_ticker ticker = quiet();
    for (int connectivity : {4, 8}) {
        for (int speck : {1, 10, 60, 400, 2500}) {
            std::vector<uint8_t> surface = bordered(map.frame, free_cells(map));
            rs_component_limits limits = {(uint32_t)speck, 0, connectivity == 8};
            rs_components_clear_small(&map.frame, limits, surface.data(), &memory.scratch,
                                      &ticker);
            check_same(map.name,
                       "obstacles below " + std::to_string(speck) + " cells, " +
                           std::to_string(connectivity) + "-connected",
                       differences(unbordered(map.frame, surface) * 255,
                                   clear_small(free_cells(map), connectivity, speck)));
        }
    }
    std::vector<uint8_t> surface = bordered(map.frame, free_cells(map));
    rs_components_keep_large_free(&map.frame, surface.data(), &memory.scratch, &ticker);
    check_same(map.name, "free islands below the mean",
               differences(unbordered(map.frame, surface) * 255, keep_large_free(free_cells(map))));
    check_islands_of_noise(map.name);
}

// OpenCV's distances are roots of whole numbers; squared and rounded they are exact.
void test_distance(const test_map &map)
{
    cv::Mat free = cleared(map), distances;
    cv::distanceTransform(widened(free, 1), distances, cv::DIST_L2, cv::DIST_MASK_PRECISE, CV_32F);
    std::vector<uint8_t> surface = bordered(map.frame, free);
    std::vector<rs_basin> envelope(map.frame.stride);
    std::vector<uint32_t> least(RS_DISTANCE_MAX + 1u);
    rs_distance_scratch scratch = {envelope.data(), least.data()};
    rs_ticker ticker = quiet();
    rs_distance_run(&map.frame, map.grid.resolution_mm, surface.data(), &scratch, &ticker);
    cv::Mat found = unbordered(map.frame, surface);
    const double mm = map.grid.resolution_mm;
    long wrong = 0;
    for (int y = 0; y < found.rows; y++) {
        for (int x = 0; x < found.cols; x++) {
            double cells = distances.at<float>(y + 1, x + 1);
            double squared = std::round(cells * cells);
            double units = std::sqrt(squared) * mm / RS_DISTANCE_UNIT_MM + 1e-9;
            double expected = std::fmin(std::fmax(std::floor(units), 1.0), RS_DISTANCE_MAX);
            wrong += found.at<uint8_t>(y, x) != (free.at<uint8_t>(y, x) == 0 ? 0.0 : expected);
        }
    }
    check_same(map.name, "distance", wrong);
}

void test_morphology(const test_map &map)
{
    cv::Mat free = cleared(map);
    std::vector<uint8_t> columns(map.frame.stride);
    rs_ticker ticker = quiet();
    for (int radius : {1, 2, 3, 7}) {
        cv::Mat square = cv::Mat::ones(2 * radius + 1, 2 * radius + 1, CV_8U), grown, shrunk;
        cv::dilate(free == 0, grown, square, cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, 255);
        std::vector<uint8_t> cells = bordered(map.frame, free);
        rs_morphology_grow_obstacles(&map.frame, (uint32_t)radius, cells.data(), columns.data(),
                                     &ticker);
        check_same(map.name, "dilation by " + std::to_string(radius),
                   differences(unbordered(map.frame, cells) * 255, grown == 0));
        cv::erode(free == 0, shrunk, square, cv::Point(-1, -1), 1, cv::BORDER_CONSTANT, 255);
        cells = bordered(map.frame, free);
        rs_morphology_shrink_obstacles(&map.frame, (uint32_t)radius, cells.data(), columns.data(),
                                       &ticker);
        check_same(map.name, "erosion by " + std::to_string(radius),
                   differences(unbordered(map.frame, cells) * 255, shrunk == 0));
    }
    // Three times 3 x 3 is once 7 x 7.
    std::vector<uint8_t> cells = bordered(map.frame, free);
    rs_morphology_grow_obstacles(&map.frame, 3, cells.data(), columns.data(), &ticker);
    check_same(map.name, "three dilations",
               differences(unbordered(map.frame, cells) * 255, dilated(map)));
}

// Components of {surface >= level}, 4-connected.
static cv::Mat components_at(const cv::Mat &surface, int level, int *count)
{
    cv::Mat labels;
    *count = cv::connectedComponents(surface >= level, labels, 4, CV_32S);
    return labels;
}

// The regions that meet in each component of a level.
static std::vector<std::set<uint16_t>> regions_in(const cv::Mat &components, int count,
                                                  const cv::Mat &peaks)
{
    std::vector<std::set<uint16_t>> found((size_t)count);
    for (int y = 0; y < components.rows; y++) {
        for (int x = 0; x < components.cols; x++) {
            if (peaks.at<uint16_t>(y, x) != 0) {
                found[(size_t)components.at<int>(y, x)].insert(peaks.at<uint16_t>(y, x));
            }
        }
    }
    return found;
}

// The label of each region on its highest cells, 0 elsewhere.
static cv::Mat peaks_of(const cv::Mat &surface, const cv::Mat &regions, uint32_t count)
{
    std::vector<uint8_t> highest(count + 1u, 0);
    cv::Mat peaks = cv::Mat::zeros(surface.size(), CV_16U);
    for (int y = 0; y < surface.rows; y++) {
        for (int x = 0; x < surface.cols; x++) {
            uint8_t &top = highest[regions.at<uint16_t>(y, x)];
            top = std::max(top, surface.at<uint8_t>(y, x));
        }
    }
    for (int y = 0; y < surface.rows; y++) {
        for (int x = 0; x < surface.cols; x++) {
            uint16_t region = regions.at<uint16_t>(y, x);
            if (region != 0 && surface.at<uint8_t>(y, x) == highest[region]) {
                peaks.at<uint16_t>(y, x) = region;
            }
        }
    }
    return peaks;
}

// What flooding from the peaks means, level by level: whenever a component of what is above the
// water holds the peak of one region only, all of it belongs to that region; none holds no peak.
void test_watershed(const test_map &map)
{
    cv::Mat surface = lifetime_of(map, dilated(map), false);
    uint32_t count = 0;
    cv::Mat regions = regions_of(map, surface, &count);
    cv::Mat peaks = peaks_of(surface, regions, count);
    check_same(map.name, "every free cell in a region", differences(regions != 0, surface != 0));
    long without_peak = 0, torn = 0;
    std::set<uint16_t> alone;
    for (int level = 1; level <= 255; level++) {
        int components;
        cv::Mat labels = components_at(surface, level, &components);
        std::vector<std::set<uint16_t>> inside = regions_in(labels, components, peaks);
        for (int c = 1; c < components; c++) {
            without_peak += inside[(size_t)c].empty();
            if (inside[(size_t)c].size() == 1) {
                alone.insert(*inside[(size_t)c].begin());
            }
        }
        for (int y = 0; y < surface.rows; y++) {
            for (int x = 0; x < surface.cols; x++) {
                const std::set<uint16_t> &here = inside[(size_t)labels.at<int>(y, x)];
                torn += labels.at<int>(y, x) != 0 && here.size() == 1 &&
                        *here.begin() != regions.at<uint16_t>(y, x);
            }
        }
    }
    check_same(map.name, "components without a peak", without_peak);
    check_same(map.name, "regions that are no regional maximum", (long)count - (long)alone.size());
    check_same(map.name, "cells of another region above the saddle", torn);
}

// A leaf seed is the component of {T >= birth} around its maximum, for the lowest birth at which
// that holds no other maximum.
void test_seeds(const test_map &map)
{
    cv::Mat surface = lifetime_of(map, dilated(map), false);
    uint32_t count = 0;
    cv::Mat labels = regions_of(map, surface, &count);
    cv::Mat peaks = peaks_of(surface, labels, count);
    cv::Mat expected = cv::Mat::zeros(surface.size(), CV_16U);
    std::vector<int> births(count + 1u, 0);
    for (int level = 255; level >= 1; level--) {
        int components;
        cv::Mat parts = components_at(surface, level, &components);
        std::vector<std::set<uint16_t>> inside = regions_in(parts, components, peaks);
        for (int y = 0; y < surface.rows; y++) {
            for (int x = 0; x < surface.cols; x++) {
                int part = parts.at<int>(y, x);
                if (part != 0 && inside[(size_t)part].size() == 1) {
                    expected.at<uint16_t>(y, x) = *inside[(size_t)part].begin();
                    births[expected.at<uint16_t>(y, x)] = level;
                }
            }
        }
    }
    std::vector<uint8_t> lifetimes((size_t)map.frame.stride * (map.frame.height + 2u), 0);
    for (int y = 0; y < surface.rows; y++) {
        std::copy(surface.ptr(y), surface.ptr(y) + surface.cols,
                  &lifetimes[rs_frame_index(&map.frame, 0, (uint32_t)y)]);
    }
    std::vector<uint8_t> found_births(count + 1u);
    rs_labels out = labels_of(labels);
    rs_ticker ticker = quiet();
    rs_seeds_run(&map.frame, lifetimes.data(), count, &out, found_births.data(), &ticker);
    check_same(map.name, "seeds at their birth", cv::countNonZero(labels != expected));
    long wrong = 0;
    for (uint32_t i = 1; i <= count; i++) {
        wrong += found_births[i] != births[i];
    }
    check_same(map.name, "births", wrong);
}
