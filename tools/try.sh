#!/bin/sh
# Installs what is missing, builds the command line, draws a sample map and segments it.
#
#   tools/try.sh [FOLDER]    FOLDER for the results; out when it is not given
set -eu

folder=${1:-}
caller=$PWD
cd "$(dirname "$0")/.."
case $folder in
'') folder=$PWD/out ;;
-*)
    echo "usage: tools/try.sh [FOLDER]" >&2
    exit 2
    ;;
/*) ;;
*) folder=$caller/$folder ;;
esac

tools/setup.sh build
mkdir -p build
echo "building ..."
{ cmake --preset tools && cmake --build --preset tools -j 2; } >build/tools.log 2>&1 ||
    { cat build/tools.log >&2; exit 1; }

roomseg=build/tools/tools/roomseg
$roomseg simulate --seed 22 -o "$folder"
$roomseg segment "$folder/map.pgm" -o "$folder"
echo
echo "Look at $folder/rooms.png: the rooms of $folder/map.pgm."
