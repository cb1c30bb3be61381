/* Maps as ROS map_server stores them: a YAML that names an image and says what it means. */
#ifndef ROOMSEG_TOOLS_MAP_YAML_H
#define ROOMSEG_TOOLS_MAP_YAML_H

#include "map.h"
#include "tool_error.h"

#define MAP_YAML_MAX_BYTES 65536u

/* Reads a map from the text of its YAML, which is changed, and the image named there.
 *
 * Keys: image (relative to the YAML's folder, or absolute), resolution [m], origin
 * [x m, y m, yaw rad], negate (0, 1, true, false), occupied_thresh and free_thresh (0..1,
 * the latter smaller); mode (trinary, the default, scale or raw) may be missing; other keys
 * are passed over.
 * A pixel v of an image whose white is w has the occupancy p = (w - v) / w, or v / w when
 * negate is set. Then by mode:
 *   trinary  p > occupied_thresh: 255; p < free_thresh: 0; between them: unknown
 *   scale    the same, but between them linear from 0 to 255
 *   raw      v (w - v when negate is set) is a percentage 0..100; above 100: unknown
 * Pixels that are not opaque are unknown in each mode.
 *
 * Fails iff: the text is no flat YAML (yaml.h), a key is missing or its value malformed or
 * out of range, the image fails to load, or memory runs out. The resolution's range is not
 * checked beyond being above 0. Returns 0, or -1 with *error set and nothing to be freed. */
int map_yaml_load(char *text, const char *path, map *out, tool_error *error);

#endif
