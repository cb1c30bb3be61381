#include "maps.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
#include "map.h"
#include "simulate/simulate.h"
#include "threshold.h"
}

static const uint8_t FREE_MAX = 51;

[[noreturn]] static void give_up(const std::string &name, const char *cause)
{
    std::fprintf(stderr, "%s: %s\n", name.c_str(), cause);
    std::exit(1);
}

static test_map make(const std::string &name, const uint8_t *cells, uint32_t width,
                     uint32_t height, uint32_t resolution_mm)
{
    test_map out;
    rs_ticker ticker;
    out.name = name;
    out.cells = cv::Mat((int)height, (int)width, CV_8U, const_cast<uint8_t *>(cells)).clone();
    out.grid = {out.cells.data, width, height, (uint32_t)out.cells.step, resolution_mm};
    std::memset(&ticker, 0, sizeof ticker);
    if (rs_threshold_crop(&out.grid, FREE_MAX, &out.frame, &ticker) != ROOMSEG_OK ||
        out.frame.width == 0) {
        give_up(name, "no free cell");
    }
    return out;
}

static test_map simulated(uint64_t seed, int noise)
{
    sim_options options = sim_options_default();
    sim_map made;
    options.seed = seed;
    options.noise = noise;
    std::string name = "simulated " + std::to_string(seed);
    if (sim_run(&options, &made) != 0) {
        give_up(name, "cannot be simulated");
    }
    test_map out = make(name, made.cells, made.width, made.height, (uint32_t)made.resolution_mm);
    sim_map_free(&made);
    return out;
}

static test_map read_map(const std::string &data_set, const std::string &name)
{
    map_options options;
    tool_error error;
    struct map loaded;
    std::memset(&options, 0, sizeof options);
    if (map_load((data_set + "/" + name).c_str(), &options, &loaded, &error) != 0) {
        give_up(name, error.text);
    }
    test_map out = make(name, loaded.cells, loaded.width, loaded.height,
                        (uint32_t)std::lround(loaded.resolution_m * 1000.0));
    map_free(&loaded);
    return out;
}

std::vector<test_map> load_maps(const char *data_set)
{
    std::vector<test_map> maps = {simulated(1, 20), simulated(2, 60)};
    if (data_set != nullptr && data_set[0] != '\0') {
        for (const char *name :
             {"furnished/01_freiburg_building52.png", "furnished/09_lab_intel.png",
              "furnished/16_office_e.png", "no_furniture/12_office_a.png", "neato/02.png",
              "neato/12.png"}) {
            maps.push_back(read_map(data_set, name));
        }
    } else {
        std::puts("no real maps; configure with -DROOMSEG_BENCHMARK_DIR=FOLDER");
    }
    return maps;
}

test_map turned_map(const test_map &of, double degrees)
{
    cv::Mat crop = crop_of(of), cells;
    int side = (int)std::ceil(std::hypot(crop.cols, crop.rows)) + 4;
    cv::Point2f middle((float)crop.cols / 2, (float)crop.rows / 2);
    cv::Mat matrix = cv::getRotationMatrix2D(middle, -degrees, 1.0);
    matrix.at<double>(0, 2) += (side - crop.cols) / 2.0;
    matrix.at<double>(1, 2) += (side - crop.rows) / 2.0;
    cv::warpAffine(crop, cells, matrix, cv::Size(side, side), cv::INTER_NEAREST,
                   cv::BORDER_CONSTANT, 127);
    return make(of.name + ", turned", cells.data, (uint32_t)side, (uint32_t)side,
                of.grid.resolution_mm);
}

cv::Mat crop_of(const test_map &of)
{
    return of.cells(cv::Rect((int)of.frame.x, (int)of.frame.y, (int)of.frame.width,
                             (int)of.frame.height));
}

cv::Mat free_cells(const test_map &of)
{
    cv::Mat out;
    cv::threshold(crop_of(of), out, FREE_MAX, 255, cv::THRESH_BINARY_INV);
    return out;
}

std::vector<uint8_t> bordered(const rs_frame &frame, const cv::Mat &mask)
{
    std::vector<uint8_t> buffer((size_t)frame.stride * (frame.height + 2u), 0);
    for (uint32_t y = 0; y < frame.height; y++) {
        for (uint32_t x = 0; x < frame.width; x++) {
            buffer[rs_frame_index(&frame, x, y)] = mask.at<uint8_t>((int)y, (int)x) != 0;
        }
    }
    return buffer;
}

cv::Mat unbordered(const rs_frame &frame, const std::vector<uint8_t> &buffer)
{
    cv::Mat whole((int)frame.height + 2, (int)frame.stride, CV_8U,
                  const_cast<uint8_t *>(buffer.data()));
    return whole(cv::Rect(1, 1, (int)frame.width, (int)frame.height)).clone();
}

cv::Mat widened(const cv::Mat &crop, int margin)
{
    cv::Mat out;
    cv::copyMakeBorder(crop, out, margin, margin, margin, margin, cv::BORDER_CONSTANT, 0);
    return out;
}

long differences(const cv::Mat &a, const cv::Mat &b)
{
    return cv::countNonZero(a != b);
}
