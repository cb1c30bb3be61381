// The stages of alignment.
#include "check.h"
#include "stages.h"

#include <opencv2/imgproc.hpp>

#include <cmath>

extern "C" {
#include "canny.h"
#include "direction.h"
#include "hough.h"
#include "rotate.h"
#include "trig.h"
}

struct edges {
    std::vector<uint8_t> buffer;
    std::vector<uint32_t> points;
    uint32_t count;
};

static edges edges_of(const test_map &map, const cv::Mat &free)
{
    edges found;
    std::vector<uint32_t> rows(ROOMSEG_CANNY_ROWS * (map.frame.stride + 2u) / 2u + 1u);
    rs_ticker ticker = quiet();
    found.buffer = bordered(map.frame, free);
    found.points.resize((size_t)map.frame.width * map.frame.height);
    rs_canny_run(&map.frame, found.buffer.data(), found.points.data(), &found.count,
                 (uint16_t *)rows.data(), &ticker);
    return found;
}

// Edges by OpenCV, with `margin` cells around the crop: the same Gaussian and thresholds; its
// crests are found among four directions instead of by interpolation.
static cv::Mat opencv_edges(const cv::Mat &free, int margin)
{
    const double scale = 4096.0; // Sobel of a step of 1 stays within 16 bits
    cv::Mat share, smooth, dx, dy, out;
    widened(free, margin).convertTo(share, CV_32F, scale / 255.0);
    cv::GaussianBlur(share, smooth, cv::Size(17, 17), 2.0, 2.0, cv::BORDER_CONSTANT);
    cv::Sobel(smooth, dx, CV_32F, 1, 0);
    cv::Sobel(smooth, dy, CV_32F, 0, 1);
    dx.convertTo(dx, CV_16S);
    dy.convertTo(dy, CV_16S);
    cv::Canny(dx, dy, out, 0.1 * scale, 0.2 * scale, true);
    return out;
}

// Share of the edges of `a` with one of `b` at most one cell away.
static double met(const cv::Mat &a, const cv::Mat &b)
{
    cv::Mat near;
    cv::dilate(b, near, cv::Mat::ones(3, 3, CV_8U));
    return (double)cv::countNonZero(a & near) / cv::countNonZero(a);
}

void test_canny(const test_map &map)
{
    const int margin = 20;
    cv::Mat free = cleared(map);
    cv::Mat found = widened(unbordered(map.frame, edges_of(map, free).buffer) * 255, margin);
    cv::Mat expected = opencv_edges(free, margin);
    check_at_least(map.name, "edges that OpenCV has too", met(found, expected), 0.99);
    // The library marks no edges outside of the crop.
    cv::Mat inside = widened(cv::Mat(free.size(), CV_8U, cv::Scalar(255)), margin);
    check_at_least(map.name, "OpenCV's edges that are found", met(expected & inside, found), 0.99);
    check_at_most(map.name, "edge cells for each of OpenCV's",
                  (double)cv::countNonZero(found) / cv::countNonZero(expected), 1.05);
    check_at_least(map.name, "edge cells for each of OpenCV's",
                   (double)cv::countNonZero(found) / cv::countNonZero(expected), 0.85);
}

// Direction of most walls by segments of OpenCV's transform, the same histogram over them.
static double opencv_direction(const cv::Mat &image, double *length)
{
    std::vector<cv::Vec4i> segments;
    std::vector<double> bins(90, 0.0), weights(90, 0.0), moments(90, 0.0);
    cv::HoughLinesP(image, segments, 1, CV_PI / 180, 20, 10, 5);
    *length = 0;
    for (const cv::Vec4i &s : segments) {
        double dx = s[2] - s[0], dy = s[3] - s[1], cells = std::hypot(dx, dy);
        double angle = std::fmod(std::atan2(dy, dx) * 180 / CV_PI + 360, 90);
        size_t bin = std::min((size_t)angle, (size_t)89);
        bins[bin] += cells;
        weights[bin] += std::pow(cells, 3);
        moments[bin] += std::pow(cells, 3) * (angle - (double)bin);
        *length += cells;
    }
    double most = 0, best = 0;
    for (size_t first = 0; first < 90; first++) {
        double sum = 0, weight = 0, moment = 0;
        for (size_t k = 0; k < 5; k++) {
            sum += bins[(first + k) % 90];
            weight += weights[(first + k) % 90];
            moment += moments[(first + k) % 90] + weights[(first + k) % 90] * (double)k;
        }
        if (sum > most) {
            most = sum;
            best = (double)first + moment / weight;
        }
    }
    return best;
}

static void compare_directions(const test_map &map)
{
    cv::Mat free = cleared(map);
    edges e = edges_of(map, free);
    cv::Mat image = unbordered(map.frame, e.buffer) * 255;
    double expected_length, length = 0;
    double expected = opencv_direction(image, &expected_length);
    std::vector<uint16_t> votes(ROOMSEG_HOUGH_ANGLES *
                                ROOMSEG_PLAN_DISTANCES(map.frame.width, map.frame.height));
    std::vector<rs_normal> normals(ROOMSEG_HOUGH_ANGLES);
    std::vector<rs_direction_bin> bins(ROOMSEG_DIRECTION_BINS);
    rs_ticker ticker = quiet();
    rs_hough hough;
    rs_hough_init(&hough, &map.frame, e.buffer.data(), e.points.data(), e.count, votes.data(),
                  normals.data());
    rs_direction_clear(bins.data());
    rs_line line;
    bool found = false;
    while (rs_hough_next(&hough, &line, &found, &ticker) == ROOMSEG_OK && found) {
        rs_direction_add(bins.data(), &line);
        length += std::hypot((double)line.x1 - line.x0, (double)line.y1 - line.y0);
    }
    // A pentagon's five directions are as good as each other.
    double period = map.name.find("16_office_e") != std::string::npos ? 18 : 90;
    double angle = rs_direction_find(bins.data()) / 100.0;
    check_at_most(map.name, "direction: degrees off OpenCV's",
                  std::fabs(std::remainder(angle - expected, period)), 1.0);
    // OpenCV takes back votes that were never given, and so finds fewer of the last segments.
    check_at_most(map.name, "length of all segments for each of OpenCV's",
                  length / expected_length, 1.4);
    check_at_least(map.name, "length of all segments for each of OpenCV's",
                   length / expected_length, 0.95);
}

void test_hough(const test_map &map)
{
    compare_directions(map);
    compare_directions(turned_map(map, 23.4));
}

// The matrix of the rotation: crop coordinates of a turned cell.
static cv::Mat matrix_of(const rs_rotation &r, const rs_frame &frame, double degrees)
{
    double c = std::cos(degrees * CV_PI / 180), s = std::sin(degrees * CV_PI / 180);
    double x = frame.width / 2, y = frame.height / 2;
    return (cv::Mat_<double>(2, 3) << c, -s, c * r.left - s * r.top + x, //
            s, c, s * r.left + c * r.top + y);
}

void test_rotate(const test_map &map)
{
    rs_ticker ticker = quiet();
    for (double degrees : {-45.0, -31.7, -3.0, 0.0, 12.5, 40.0}) {
        std::string name = "turned by " + std::to_string((int)std::lround(degrees));
        rs_rotation r;
        rs_rotate_init(&map.frame, &map.grid, 51, (int32_t)std::lround(degrees * 100), &r, &ticker);
        cv::Size size((int)r.width, (int)r.height);
        cv::Mat turned(size, CV_8U), matrix = matrix_of(r, map.frame, degrees);
        cv::Mat offset = matrix.clone();
        offset.at<double>(0, 2) += map.frame.x;
        offset.at<double>(1, 2) += map.frame.y;
        // Obstacles where the bilinear mixture of free and not free says so, the unknown whole
        // or half.
        for (uint8_t whole_min : {0, 204}) {
            cv::Mat whole = (map.cells > 51), half = whole & (map.cells < whole_min);
            cv::Mat mixture, share;
            rs_mixture how = {51, whole_min, 127};
            rs_rotate_grid(&r, &map.grid, how, turned.data, r.width, &ticker);
            cv::addWeighted(whole, 1.0 / 255.0, half, -0.5 / 255.0, 0.0, share, CV_32F);
            cv::warpAffine(share, mixture, offset, size, cv::INTER_LINEAR | cv::WARP_INVERSE_MAP,
                           cv::BORDER_CONSTANT, whole_min == 0 ? 1.0 : 0.5);
            check_at_most(map.name, name + ": share of obstacles that differ",
                          (double)differences(mixture > 0.2f, turned > 51) /
                              (double)turned.total(),
                          0.001);
        }
        // Labels back: what the turned frame has, from the nearest cell.
        cv::Mat labels(size, CV_16U), nearest, mask(size, CV_8U);
        cv::randu(labels, 1, 60000);
        cv::GaussianBlur(labels, labels, cv::Size(15, 15), 4); // neighbours alike, as in rooms
        cv::Mat back = cv::Mat::zeros((int)map.frame.height, (int)map.frame.width, CV_16U);
        rs_labels out = labels_of(back);
        std::vector<uint8_t> open = bordered(map.frame, free_cells(map));
        rs_rotate_labels_back(&r, labels.ptr<uint16_t>(), open.data(), &out, &ticker);
        cv::warpAffine(labels, nearest, matrix, back.size(), cv::INTER_NEAREST,
                       cv::BORDER_CONSTANT, 0);
        nearest.setTo(0, free_cells(map) == 0);
        check_at_most(map.name, name + ": share of labels back that differ",
                      (double)cv::countNonZero(back != nearest) /
                          cv::countNonZero(free_cells(map)),
                      0.004);
    }
}
