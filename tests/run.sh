#!/bin/sh
# Installs what is missing, builds everything and runs the tests.
#
#   tests/run.sh [PRESET]    PRESET is default when it is not given
set -eu

cd "$(dirname "$0")/.."
preset=${1:-default}
case $preset in
-*)
    echo "usage: tests/run.sh [PRESET]" >&2
    exit 2
    ;;
esac

tools/setup.sh test
jobs=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
cmake --preset "$preset"
cmake --build --preset "$preset" -j "$jobs"
ctest --preset "$preset" -j "$jobs"
