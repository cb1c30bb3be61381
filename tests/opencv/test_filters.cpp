// Stages that approximate a filter: the difference is measured and bounded.
#include "check.h"
#include "stages.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

extern "C" {
#include "blur.h"
#include "queue.h"
#include "ridge.h"
#include "seeds.h"
#include "watershed_lines.h"
}

// Free share after a Gaussian, in floating point; outside of the crop there is none.
static cv::Mat gaussian(const cv::Mat &image, double sigma)
{
    int size = 2 * (int)std::ceil(6.0 * sigma) + 1;
    cv::Mat out;
    cv::GaussianBlur(image, out, cv::Size(size, size), sigma, sigma, cv::BORDER_CONSTANT);
    return out;
}

static cv::Mat shares_of(const cv::Mat &free, int margin)
{
    cv::Mat out;
    widened(free, margin).convertTo(out, CV_64F, 1.0 / 255.0);
    return out;
}

// One step of the library's cascade.
struct cascade {
    std::vector<uint16_t> cells, ring;
    std::vector<uint32_t> sums, prefix;
    rs_blur blur;
    uint32_t variance; // so far [2^-16 cells^2]

    cascade(const cv::Mat &free, int margin)
    {
        cv::Mat wide = widened(free, margin);
        uint32_t rows = RS_BLUR_MAX_RADIUS + 3u, width = (uint32_t)wide.cols;
        for (int y = 0; y < wide.rows; y++) {
            for (int x = 0; x < wide.cols; x++) {
                cells.push_back(wide.at<uint8_t>(y, x) != 0 ? UINT16_MAX : 0);
            }
        }
        ring.resize((size_t)rows * width);
        sums.resize(width);
        prefix.resize(width + 2u * rows);
        variance = 0;
        blur = {cells.data(), width, (uint32_t)wide.rows, {0, 0, 0},
                {sums.data(), prefix.data(), ring.data(), rows}};
    }

    void to(double sigma)
    {
        uint32_t aim = (uint32_t)std::lround(sigma * sigma * 65536.0);
        blur.box = rs_box_of_variance(aim - variance);
        variance += rs_box_variance(&blur.box);
        rs_blur_begin(&blur);
        for (uint32_t y = 0; y < blur.height; y++) {
            rs_blur_row(&blur, y);
        }
    }
};

// Three boxes for the first sigma, one for each step from there on.
void test_blur(const test_map &map)
{
    const int margin = 40;
    const double sigmas[] = {1.0, 1.5, 2.0, 4.0, 8.0};
    const double worst[] = {0.015, 0.022, 0.025, 0.015, 0.010};
    const double mean[] = {0.001, 0.0025, 0.003, 0.003, 0.002};
    cv::Mat free = cleared(map), exact = shares_of(free, margin);
    cascade boxes(free, margin);
    boxes.to(std::sqrt(1.0 / 3.0));
    boxes.to(std::sqrt(2.0 / 3.0));
    size_t row = 0;
    for (double sigma = 1.0; sigma <= 8.0; sigma += 0.5) {
        boxes.to(sigma);
        if (sigma != sigmas[row]) {
            continue;
        }
        cv::Mat found((int)boxes.blur.height, (int)boxes.blur.width, CV_16U, boxes.cells.data());
        cv::Mat share, off;
        found.convertTo(share, CV_64F, 1.0 / 65535.0);
        cv::absdiff(share, gaussian(exact, sigma), off);
        off = off(cv::Rect(margin, margin, free.cols, free.rows));
        double most;
        cv::minMaxLoc(off, nullptr, &most);
        std::string name = "sigma " + std::to_string(sigma).substr(0, 3);
        check_at_most(map.name, name + ": greatest error", most, worst[row]);
        check_at_most(map.name, name + ": mean error", cv::mean(off)[0], mean[row]);
        row++;
    }
}

// Lifetimes by exact Gaussians: each scale from the one before, in double precision.
static cv::Mat exact_lifetimes(const cv::Mat &free)
{
    const int margin = 160;
    cv::Mat share = shares_of(free, margin);
    cv::Mat lifetimes = cv::Mat::zeros(free.size(), CV_8U);
    double before = 0.0;
    for (int scale = 1; scale <= 254; scale++) {
        double sigma = 1.0 + 0.5 * (scale - 1);
        share = gaussian(share, std::sqrt(sigma * sigma - before * before));
        before = sigma;
        cv::Mat seeds = share(cv::Rect(margin, margin, free.cols, free.rows)) >= 0.95;
        if (cv::countNonZero(seeds) == 0) {
            break;
        }
        lifetimes.setTo(scale, seeds);
    }
    return lifetimes;
}

// Over all maps.
static double halved_far_off, halved_cells;

static void compare_lifetimes(const test_map &map, const std::string &name, const cv::Mat &found,
                              const cv::Mat &exact, double most_off, double most_far_off)
{
    cv::Mat off;
    cv::absdiff(found, exact, off);
    double cells = cv::countNonZero(exact | found);
    check_at_most(map.name, name + ": share of cells off", cv::countNonZero(off) / cells, most_off);
    check_at_most(map.name, name + ": share off by more than one scale",
                  cv::countNonZero(off > 1) / cells, most_far_off);
}

void test_lifetime(const test_map &map)
{
    cv::Mat free = dilated(map), exact = exact_lifetimes(free), off;
    cv::Mat halved = lifetime_of(map, free, true);
    compare_lifetimes(map, "full grid", lifetime_of(map, free, false), exact, 0.05, 0.001);
    // One hall of even width may lie wholly on the wrong side of a rounding.
    compare_lifetimes(map, "halved grids", halved, exact, 0.15, 0.003);
    cv::absdiff(halved, exact, off);
    halved_far_off += cv::countNonZero(off > 1);
    halved_cells += cv::countNonZero(exact | halved);
}

void finish_lifetime()
{
    check_at_most("all maps", "halved grids: share off by more than one scale",
                  halved_far_off / halved_cells, 0.001);
}

// Meijering's filter with derivatives of a Gaussian, sigma 2, alpha 1/3, on the free cells.
static cv::Mat exact_ridges(const cv::Mat &free)
{
    const int margin = 20, radius = 12;
    const double sigma = 2.0, alpha = 1.0 / 3.0;
    cv::Mat value(1, 2 * radius + 1, CV_64F), first = value.clone(), second = value.clone();
    for (int k = -radius; k <= radius; k++) {
        double g = std::exp(-k * k / (2 * sigma * sigma)) / (sigma * std::sqrt(2 * CV_PI));
        value.at<double>(k + radius) = g;
        first.at<double>(k + radius) = -k / (sigma * sigma) * g;
        second.at<double>(k + radius) = (k * k / (sigma * sigma) - 1) / (sigma * sigma) * g;
    }
    cv::Mat obstacles = 1.0 - shares_of(free, margin), xx, yy, xy;
    cv::sepFilter2D(obstacles, xx, CV_64F, second, value);
    cv::sepFilter2D(obstacles, yy, CV_64F, value, second);
    cv::sepFilter2D(obstacles, xy, CV_64F, first, first);
    cv::Mat out = cv::Mat::zeros(free.size(), CV_64F);
    for (int y = 0; y < free.rows; y++) {
        for (int x = 0; x < free.cols; x++) {
            double a = xx.at<double>(y + margin, x + margin);
            double b = yy.at<double>(y + margin, x + margin);
            double c = xy.at<double>(y + margin, x + margin);
            double root = std::sqrt((a - b) * (a - b) + 4 * c * c);
            // Dark ridges between bright obstacles: of the negated map, as scikit-image has it.
            double p = (a + b + root) / 2, q = (a + b - root) / 2;
            double one = p + alpha * q, two = q + alpha * p;
            double strongest = std::fabs(one) > std::fabs(two) ? one : two;
            out.at<double>(y, x) = std::fmax(strongest, 0.0);
        }
    }
    return out;
}

static double correlation(const std::vector<double> &a, const std::vector<double> &b)
{
    double mean_a = 0, mean_b = 0, ab = 0, aa = 0, bb = 0;
    for (size_t i = 0; i < a.size(); i++) {
        mean_a += a[i] / (double)a.size();
        mean_b += b[i] / (double)a.size();
    }
    for (size_t i = 0; i < a.size(); i++) {
        ab += (a[i] - mean_a) * (b[i] - mean_b);
        aa += (a[i] - mean_a) * (a[i] - mean_a);
        bb += (b[i] - mean_b) * (b[i] - mean_b);
    }
    return ab / std::sqrt(aa * bb);
}

// The library's ridge map; 8 bit.
static cv::Mat ridges_of(const test_map &map, const cv::Mat &free)
{
    const uint32_t mm = map.grid.resolution_mm;
    std::vector<uint8_t> cells = bordered(map.frame, free);
    std::vector<uint16_t> roots((size_t)map.frame.width * map.frame.height);
    std::vector<uint32_t> rows((size_t)ROOMSEG_RIDGE_ROWS * map.frame.stride + 2u);
    rs_ridge_scratch scratch = {roots.data(), rows.data()};
    rs_ticker ticker = quiet();
    rs_ridge_run(&map.frame, 2u * mm, mm, cells.data(), &scratch, &ticker);
    return unbordered(map.frame, cells);
}

void test_ridge(const test_map &map)
{
    cv::Mat free = cleared(map), exact = exact_ridges(free), found = ridges_of(map, free);
    std::vector<double> a, b;
    double greatest = 0, sum = 0, far_off = 0;
    cv::minMaxLoc(exact, nullptr, &greatest, nullptr, nullptr, free);
    for (int y = 0; y < free.rows; y++) {
        for (int x = 0; x < free.cols; x++) {
            if (free.at<uint8_t>(y, x) != 0) {
                double root = found.at<uint8_t>(y, x) / (double)RS_RIDGE_MAX;
                a.push_back(exact.at<double>(y, x) / greatest);
                b.push_back(root * root);
                sum += std::fabs(a.back() - b.back());
                far_off += std::fabs(a.back() - b.back()) > 0.02;
            }
        }
    }
    check_same(map.name, "obstacles", differences(found == RS_RIDGE_OBSTACLE, free == 0));
    check_at_least(map.name, "ridge: correlation", correlation(a, b), 0.99);
    check_at_most(map.name, "ridge: mean error", sum / (double)a.size(), 0.002);
    // The value jumps to 0 where the trace changes its sign, so single cells may be far off.
    check_at_most(map.name, "ridge: share of cells off by more than 0.02",
                  far_off / (double)a.size(), 0.002);
}

// The library's markers for the flood: leaf seeds at their birth, and the obstacles.
static cv::Mat markers_of(const test_map &map, const cv::Mat &free)
{
    cv::Mat lifetimes = lifetime_of(map, dilated(map), false);
    uint32_t count = 0;
    cv::Mat labels = regions_of(map, lifetimes, &count);
    std::vector<uint8_t> cells((size_t)map.frame.stride * (map.frame.height + 2u), 0);
    std::vector<uint8_t> births(count + 1u);
    rs_labels out = labels_of(labels);
    rs_ticker ticker = quiet();
    for (int y = 0; y < lifetimes.rows; y++) {
        std::copy(lifetimes.ptr(y), lifetimes.ptr(y) + lifetimes.cols,
                  &cells[rs_frame_index(&map.frame, 0, (uint32_t)y)]);
    }
    rs_seeds_run(&map.frame, cells.data(), count, &out, births.data(), &ticker);
    cells = bordered(map.frame, free);
    rs_seeds_mark_obstacles(&map.frame, cells.data(), RS_BACKGROUND, &out, &ticker);
    return labels;
}

// The lowest height up to which one has to climb from a marker to each cell; with basins, on
// cells of the marker's basin alone.
static cv::Mat heights_to_climb(const cv::Mat &ridges, const cv::Mat &markers,
                                const cv::Mat *basins)
{
    std::vector<std::vector<cv::Point>> levels(256);
    cv::Mat climbed(ridges.size(), CV_8U, cv::Scalar(255));
    cv::Rect inside(cv::Point(0, 0), ridges.size());
    for (int y = 0; y < ridges.rows; y++) {
        for (int x = 0; x < ridges.cols; x++) {
            if (markers.at<int>(y, x) != 0) {
                climbed.at<uint8_t>(y, x) = 0;
                levels[0].push_back({x, y});
            }
        }
    }
    for (size_t level = 0; level < 256; level++) {
        for (size_t i = 0; i < levels[level].size(); i++) {
            cv::Point from = levels[level][i];
            for (int k = 0; k < 9; k++) {
                cv::Point to(from.x + k % 3 - 1, from.y + k / 3 - 1);
                if (!inside.contains(to) ||
                    (basins != nullptr && basins->at<uint16_t>(to) != basins->at<uint16_t>(from))) {
                    continue;
                }
                size_t height = std::max(level, (size_t)ridges.at<uint8_t>(to));
                if (height < climbed.at<uint8_t>(to)) {
                    climbed.at<uint8_t>(to) = (uint8_t)height;
                    levels[height].push_back(to);
                }
            }
        }
    }
    return climbed;
}

// Share of the cells in basins that are reached from another marker on a lower way.
static double share_beyond_ridges(const cv::Mat &ridges, const cv::Mat &markers,
                                  const cv::Mat &basins)
{
    cv::Mat lowest = heights_to_climb(ridges, markers, nullptr);
    cv::Mat own = heights_to_climb(ridges, markers, &basins);
    cv::Mat cells = (basins != (int)RS_LINE) & (markers == 0);
    return (double)cv::countNonZero((own > lowest) & cells) / cv::countNonZero(cells);
}

// Lines separate: no two basins touch, not even at corners, except where their markers do. The
// basins are compared with OpenCV's flood of the same surface from the same markers. That one goes
// by differences between neighbours instead of heights, so it agrees in the large only.
void test_watershed_lines(const test_map &map)
{
    cv::Mat free = cleared(map), ridges = ridges_of(map, free);
    cv::Mat labels = markers_of(map, free), markers;
    labels.convertTo(markers, CV_32S);
    std::vector<uint8_t> surface((size_t)map.frame.stride * (map.frame.height + 2u),
                                 RS_RIDGE_OBSTACLE);
    std::vector<rs_queue_list> lists(RS_QUEUE_LISTS);
    std::vector<rs_queue_block> blocks((size_t)free.total() / 4 + 1024);
    rs_labels out = labels_of(labels);
    rs_ticker ticker = quiet();
    rs_queue queue;
    for (int y = 0; y < ridges.rows; y++) {
        std::copy(ridges.ptr(y), ridges.ptr(y) + ridges.cols,
                  &surface[rs_frame_index(&map.frame, 0, (uint32_t)y)]);
    }
    rs_queue_init(&queue, lists.data(), blocks.data(), (uint32_t)blocks.size());
    rs_watershed_lines_run(&map.frame, surface.data(), &out, &queue, &ticker);
    long touching = 0, moved = 0, same = 0, compared = 0;
    cv::Mat image, flooded = markers.clone();
    cv::cvtColor(ridges, image, cv::COLOR_GRAY2BGR);
    cv::watershed(image, flooded);
    for (int y = 0; y + 1 < labels.rows; y++) {
        for (int x = 0; x + 1 < labels.cols; x++) {
            uint16_t here = labels.at<uint16_t>(y, x);
            int marker = markers.at<int>(y, x);
            moved += marker != 0 && marker != here;
            const cv::Point ahead[] = {{x + 1, y}, {x, y + 1}, {x + 1, y + 1}};
            for (cv::Point to : ahead) {
                uint16_t next = labels.at<uint16_t>(to);
                touching += here != RS_LINE && next != RS_LINE && here != next &&
                            (marker == 0 || markers.at<int>(to) == 0);
            }
            if (free.at<uint8_t>(y, x) != 0 && here < RS_BACKGROUND && flooded.at<int>(y, x) > 0) {
                compared++;
                same += flooded.at<int>(y, x) == here;
            }
        }
    }
    check_at_most(map.name, "basins: share of cells beyond a ridge",
                  share_beyond_ridges(ridges, markers, labels), 0.0);
    check_same(map.name, "markers that changed", moved);
    check_same(map.name, "basins that touch", touching);
    check_at_least(map.name, "basins: share like OpenCV's", (double)same / (double)compared, 0.9);
}
