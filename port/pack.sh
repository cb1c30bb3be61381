#!/bin/sh
# Puts the library together as others' package managers want it: manifest, sources, headers.
#
#   port/pack.sh arduino|platformio|esp-idf FOLDER    makes FOLDER/roomseg
set -eu

usage() {
    echo "usage: port/pack.sh arduino|platformio|esp-idf FOLDER" >&2
    exit 2
}

[ $# -eq 2 ] || usage
kind=$1
root=$(cd "$(dirname "$0")/.." && pwd)
to=$2/roomseg
if [ -e "$to" ]; then
    echo "pack: $to is there already" >&2
    exit 1
fi

case $kind in
arduino)
    # Arduino knows no include folder: everything lies under src. It finds a library by the headers
    # at the top there, which must not be those of the stages: a sketch may have its own queue.h.
    mkdir -p "$to/src/stages"
    cp -R "$root"/port/arduino/* "$to"
    cp "$root"/src/*.[ch] "$to/src/stages"
    cp -R "$root/include/roomseg" "$to/src"
    ;;
platformio | esp-idf)
    mkdir -p "$to/src"
    case $kind in
    platformio) cp "$root"/port/platformio/library.json "$to" ;;
    esp-idf) cp "$root"/port/esp-idf/roomseg/* "$to" ;;
    esac
    cp "$root"/src/*.[ch] "$to/src"
    cp -R "$root/include" "$to"
    ;;
*) usage ;;
esac
cp "$root/LICENSE" "$to"
echo "$to"
