// Holds each stage of the library against OpenCV.
//
//   test_opencv STAGE [FOLDER]    FOLDER: a data set with furnished/, no_furniture/, neato/
//
// Exact where a stage is exact; where it approximates, the difference is measured and bounded.
#include "check.h"
#include "stages.h"

#include <cstdio>
#include <cstring>

struct stage {
    const char *name;
    void (*test)(const test_map &map);
    void (*finish)(); // checks over all maps together; may be null
};

static const stage stages[] = {
    {"threshold", test_threshold, nullptr},
    {"components", test_components, nullptr},
    {"distance", test_distance, nullptr},
    {"watershed", test_watershed, nullptr},
    {"morphology", test_morphology, nullptr},
    {"blur", test_blur, nullptr},
    {"lifetime", test_lifetime, finish_lifetime},
    {"seeds", test_seeds, nullptr},
    {"ridge", test_ridge, nullptr},
    {"watershed_lines", test_watershed_lines, nullptr},
    {"canny", test_canny, nullptr},
    {"hough", test_hough, nullptr},
    {"rotate", test_rotate, nullptr},
};

int main(int argc, char **argv)
{
    for (const stage &s : stages) {
        if (argc >= 2 && std::strcmp(argv[1], s.name) == 0) {
            for (const test_map &map : load_maps(argc >= 3 ? argv[2] : nullptr)) {
                s.test(map);
            }
            if (s.finish != nullptr) {
                s.finish();
            }
            return check_summary();
        }
    }
    std::fprintf(stderr, "usage: test_opencv STAGE [FOLDER]\n");
    return 2;
}
