/* Label images, their truth and the score of one against the other. The input: a byte of
 * options, the length of the labels' file (two bytes), that file, the truth's file. */
#include <math.h>
#include <string.h>

#include "check_map.h"
#include "memory_files.h"
#include "score.h"
#include "truth.h"
#include "unity.h"

/* Every share lies within 0..1, but AMI and ARI, which may be negative. */
static void check_metrics(const metrics *m)
{
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        double value = metrics_get(m, i);
        TEST_ASSERT_TRUE(isfinite(value) && value < 1.0 + 1e-9);
        TEST_ASSERT_TRUE(value > -1e-9 || i == METRIC_AMI || i == METRIC_ARI);
    }
    TEST_ASSERT_TRUE(m->rooms_matched <= m->rooms_true && m->rooms_matched <= m->rooms_found);
}

static void check_score(const label_image *truth, const label_image *labels)
{
    score s;
    tool_error error = {""};
    int same = truth->width == labels->width && truth->height == labels->height;
    int rc = score_labels(truth, labels, "labels", &s, &error);
    TEST_ASSERT_TRUE((rc == 0) == same);
    if (rc == 0) {
        check_metrics(&s.all);
        check_metrics(&s.without_specks);
    } else {
        check_error(&error, "labels");
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 3) {
        return 0;
    }
    truth_kind kind = (truth_kind)(bytes[0] % 3);
    size_t length = bytes[1] + (size_t)256 * bytes[2];
    bytes += 3;
    size -= 3;
    length = length < size ? length : size;
    label_image labels;
    label_image truth;
    tool_error error = {""};
    memory_files_set(bytes, length, bytes + length, size - length);
    if (label_image_load("labels", &labels, &error) != 0) {
        check_error(&error, "labels");
        TEST_ASSERT_TRUE(labels.values == NULL);
        return 0;
    }
    if (truth_load("truth", kind, &truth, &error) != 0) {
        check_error(&error, "truth");
        TEST_ASSERT_TRUE(truth.values == NULL);
    } else {
        check_score(&truth, &labels);
        label_image_free(&truth);
    }
    label_image_free(&labels);
    return 0;
}
