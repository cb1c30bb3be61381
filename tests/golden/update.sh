#!/bin/sh
# Writes tests/golden/*.txt anew from what the library does now, and draws each change: the old
# labels, the new ones, and in red the cells that went to another room.
#
#   tests/golden/update.sh [FOLDER]    FOLDER for the pictures; build/golden when it is not given
set -eu

folder=${1:-}
caller=$PWD
cd "$(dirname "$0")/../.."
case $folder in
'') pictures=build/golden ;;
-*)
    echo "usage: tests/golden/update.sh [FOLDER]" >&2
    exit 2
    ;;
/*) pictures=$folder ;;
*) pictures=$caller/$folder ;;
esac

tools/setup.sh test
{ cmake --preset default && cmake --build --preset default -j 2 --target update_golden; } \
    >build/golden.log 2>&1 || { cat build/golden.log >&2; exit 1; }
build/default/tests/update_golden tests/golden "$pictures"
git --no-pager diff --stat -- tests/golden
echo "Other rooms change the checksums in README.md too, those of real maps as well:"
echo "tests/embedded/run.py --update --dataset FOLDER"
