#!/bin/sh
# Writes tests/golden/*.txt anew from what the library does now, and draws each change: the old
# labels, the new ones, and in red the cells that went to another room.
#
#   tests/golden/update.sh [FOLDER]    FOLDER for the pictures; build/golden when it is not given
set -eu

cd "$(dirname "$0")/../.."
pictures=${1:-build/golden}

tools/setup.sh test
{ cmake --preset default && cmake --build --preset default -j 2 --target update_golden; } \
    >build/golden.log 2>&1 || { cat build/golden.log >&2; exit 1; }
build/default/tests/update_golden tests/golden "$pictures"
git --no-pager diff --stat -- tests/golden
echo "Other rooms change the checksums in README.md too: tests/embedded/run.py --update"
