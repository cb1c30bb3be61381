#!/bin/sh
# Static analysis of the library: gcc -fanalyzer, clang-tidy (.clang-tidy) and cppcheck. Silent but
# for one line a tool; exit code 1 when one has something to say.
set -eu

cd "$(dirname "$0")/.."
for tool in gcc clang-tidy cppcheck; do
    command -v $tool >/dev/null 2>&1 || {
        echo "lint: $tool is missing; tools/setup.sh ci installs it" >&2
        exit 2
    }
done
failed=0
mkdir -p build/lint

verdict() { # NAME FILE: clean when nothing was written
    if [ -s "$2" ]; then
        cat "$2"
        echo "lint: $1: findings" >&2
        failed=1
    else
        echo "lint: $1: clean"
    fi
}

for file in src/*.c; do
    gcc -std=c99 -O2 -fanalyzer -Wall -Wextra -Wconversion -Wshadow -Wvla -Wcast-qual \
        -Wstrict-prototypes -Wmissing-prototypes -Wpointer-arith -Wundef -Iinclude -c "$file" \
        -o build/lint/object.o
done >build/lint/gcc.txt 2>&1 || true
verdict "gcc -fanalyzer" build/lint/gcc.txt

clang-tidy --quiet src/*.c -- -std=c99 -Iinclude -Isrc 2>/dev/null >build/lint/tidy.txt || true
verdict "clang-tidy" build/lint/tidy.txt

cppcheck --quiet --std=c99 --enable=warning,performance,portability --inline-suppr \
    --suppress=missingIncludeSystem -Iinclude -Isrc src >build/lint/cppcheck.txt 2>&1 || true
verdict "cppcheck" build/lint/cppcheck.txt
exit $failed
