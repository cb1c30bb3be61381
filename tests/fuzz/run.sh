#!/bin/sh
# Fuzzes the library and the readers of files, all targets at once, and fails on a finding.
#
#   tests/fuzz/run.sh [SECONDS [TARGET...]]    SECONDS is 10, the targets are all of
#                                              library, map, png, labels
#
# Needs clang. Begins with the inputs in tests/fuzz/corpus and those of earlier runs in
# build/fuzz/found; a finding is written to build/fuzz/finding-TARGET-*, and
#   build/fuzz/TARGET FILE
# repeats it.
set -eu

cd "$(dirname "$0")/../.."
seconds=${1:-10}
[ $# -eq 0 ] || shift
targets=${*:-library map png labels}
out=build/fuzz

command -v clang >/dev/null 2>&1 || {
    echo "fuzz: clang is missing; tools/setup.sh ci installs it" >&2
    exit 2
}
flags="-std=c99 -D_POSIX_C_SOURCE=200809L -g -O2 -fsanitize=address,undefined
    -fno-sanitize-recover=all -fno-omit-frame-pointer -Wall -Wextra -Wshadow -Werror
    -Iinclude -Itests/fuzz -Itests/support -Itools"
support="tests/fuzz/fail.c tests/support/check.c tests/support/check_labels.c
    tests/support/check_rooms.c tests/support/check_doorways.c tests/support/reference.c
    tests/support/config_fields.c tests/support/run.c tests/fuzz/scenario.c"
readers="tests/fuzz/fail.c tests/fuzz/memory_files.c tests/fuzz/check_map.c tools/image.c
    tools/map_pgm.c tools/png_check.c tools/tool_error.c tools/args.c tools/map.c
    tools/map_yaml.c tools/yaml.c"
metrics="tools/label_image.c tools/truth.c tools/score.c tools/contingency.c tools/metrics.c
    tools/partition.c tools/expected_mi.c"

# Only the library is watched for new paths, and its comparisons are not: they are many, and
# against numbers that nobody has to guess.
build_library() {
    mkdir -p "$out/library.o"
    for file in $support src/*.c; do
        watch=
        case $file in src/*) watch="-fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp" ;; esac
        object=$out/library.o/$(echo "$file" | tr / _).o
        # shellcheck disable=SC2086 # words, here and below
        clang $flags $watch -c "$file" -o "$object"
    done
    clang $flags -fsanitize=fuzzer tests/fuzz/fuzz_library.c "$out"/library.o/*.o -o "$out/library"
}

build() { # TARGET
    case $1 in
    library) build_library ;;
    map | png | labels)
        extra=
        [ "$1" != png ] || extra=tests/fuzz/png_repair.c
        [ "$1" != labels ] || extra=$metrics
        stb=$(pkg-config --cflags-only-I stb | sed 's/-I/-isystem /g')
        clang $flags $stb -fsanitize=fuzzer "tests/fuzz/fuzz_$1.c" $readers $extra \
            -o "$out/$1" -lm
        ;;
    *)
        echo "usage: tests/fuzz/run.sh [SECONDS [library|map|png|labels]...]" >&2
        exit 2
        ;;
    esac
}

fuzz() { # TARGET
    mkdir -p "$out/found/$1"
    words=
    [ "$1" != png ] || words=-dict=tests/fuzz/png.dict
    [ "$1" != map ] && [ "$1" != labels ] || words=-dict=tests/fuzz/map.dict
    nice -n 19 "$out/$1" $words -max_len=1500 -max_total_time="$seconds" -print_final_stats=1 \
        -artifact_prefix="$out/finding-$1-" "$out/found/$1" "tests/fuzz/corpus/$1" \
        >"$out/$1.log" 2>&1
}

for target in $targets; do
    rm -rf "$out/$target.o"
    mkdir -p "$out"
    build "$target"
done
for target in $targets; do
    { fuzz "$target" && rm -f "$out/$target.bad" || touch "$out/$target.bad"; } &
done
wait
rc=0
for target in $targets; do
    count=$(sed -n 's/^stat::number_of_executed_units: *//p' "$out/$target.log")
    if [ -e "$out/$target.bad" ]; then
        rm "$out/$target.bad"
        tail -n 40 "$out/$target.log"
        echo "fuzz: $target: FINDING after ${count:-?} executions, see $out/$target.log" >&2
        rc=1
    else
        echo "fuzz: $target: $count executions without a finding"
    fi
done
exit $rc
