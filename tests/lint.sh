#!/bin/sh
# Static analysis of the library: gcc -fanalyzer, clang-tidy (.clang-tidy), cppcheck, and the rules
# of MISRA C:2012 (tests/misra_deviations.txt). Silent but for one line a tool; exit code 1 when one
# has something to say.
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
        -o build/lint/object.o || echo "$file: exit code $?"
done >build/lint/gcc.txt 2>&1
verdict "gcc -fanalyzer" build/lint/gcc.txt

clang-tidy --quiet src/*.c -- -std=c99 -Iinclude -Isrc 2>/dev/null >build/lint/tidy.txt ||
    echo "clang-tidy: exit code $?" >>build/lint/tidy.txt
verdict "clang-tidy" build/lint/tidy.txt

# cppcheck knows no SIZE_MAX, and leaves out, in silence, a file that ends in #error without it.
# Not its arrayIndexThenCheck: an index that is compared with another index is not being checked.
cppcheck --quiet --std=c99 --enable=warning,performance,portability --inline-suppr -j 2 \
    --suppress=missingIncludeSystem --suppress=arrayIndexThenCheck -DSIZE_MAX=0xFFFFFFFFu \
    --addon=misra --template='{file}:{line}: {message} [{id}]' --template-location='' \
    -Iinclude -Isrc src >build/lint/all.txt 2>&1 ||
    echo "cppcheck: exit code $?" >>build/lint/all.txt
grep -v misra-c2012 build/lint/all.txt >build/lint/cppcheck.txt || true
verdict "cppcheck" build/lint/cppcheck.txt

# What the list of deviations does not cover, then lines of the list that nothing needs.
awk '
    FNR == NR {
        if ($0 !~ /^#/ && NF > 0) {
            files[$1] = "," $3 ","
        }
        next
    }
    match($0, /misra-c2012-[0-9.]+/) {
        rule = substr($0, RSTART + 12, RLENGTH - 12)
        file = $0
        sub(/:.*/, "", file)
        sub(/.*\//, "", file)
        seen[rule] = seen[rule] "," file ","
        if (files[rule] != ",*," && !index(files[rule], "," file ",")) {
            print
        }
    }
    END {
        for (rule in files) {
            count = split(files[rule], names, ",")
            for (i = 2; i < count; i++) {
                if (names[i] == "*" ? !seen[rule] : !index(seen[rule], "," names[i] ",")) {
                    print "tests/misra_deviations.txt: " rule " " names[i] ": nothing needs it"
                }
            }
        }
    }' tests/misra_deviations.txt build/lint/all.txt >build/lint/misra.txt
verdict "MISRA C:2012" build/lint/misra.txt
exit $failed
