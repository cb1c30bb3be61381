#!/bin/sh
# Fuzzes the library and the readers of files, all targets at once, and fails on a finding.
#
#   tests/fuzz/run.sh [check|SECONDS [TARGET...]]    all targets: library, map, png, labels
#
# check, the default, tries the same inputs each time, so that only a change of the code can make
# it fail. SECONDS is for finding something new: other inputs each time, from those of earlier
# runs in build/fuzz/found on. Both begin with tests/fuzz/corpus. Needs clang. A finding is
# written to build/fuzz/finding-TARGET-*, and
#   build/fuzz/TARGET FILE
# repeats it.
set -eu

usage() {
    echo "usage: tests/fuzz/run.sh [check|SECONDS [library|map|png|labels]...]" >&2
    exit 2
}

cd "$(dirname "$0")/../.."
seconds=${1:-check}
[ $# -eq 0 ] || shift
case $seconds in
check) ;;
*[!0-9]* | "") usage ;;
esac
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
    *) usage ;;
    esac
}

# The same inputs each time: a number of runs instead of a time, seeds in the order of their names
# instead of the file system's, and no hints from comparisons, which depend on addresses.
begin_check() { # TARGET, sets arguments
    case $1 in
    library) runs=4000 ;;
    *) runs=200000 ;;
    esac
    rm -rf "$out/checked/$1"
    mkdir -p "$out/checked/$1"
    (LC_ALL=C && export LC_ALL && echo tests/fuzz/corpus/"$1"/* | tr ' ' ,) >"$out/$1.seeds"
    arguments="-seed=1 -runs=$runs -use_cmp=0 -reload=0 -seed_inputs=@$out/$1.seeds
        $out/checked/$1"
}

fuzz() { # TARGET
    words=
    [ "$1" != png ] || words=-dict=tests/fuzz/png.dict
    [ "$1" != map ] && [ "$1" != labels ] || words=-dict=tests/fuzz/map.dict
    if [ "$seconds" = check ]; then
        begin_check "$1"
    else
        mkdir -p "$out/found/$1"
        arguments="-max_total_time=$seconds $out/found/$1 tests/fuzz/corpus/$1"
    fi
    # shellcheck disable=SC2086 # words
    nice -n 19 "$out/$1" $words -max_len=1500 -print_final_stats=1 \
        -artifact_prefix="$out/finding-$1-" $arguments >"$out/$1.log" 2>&1
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
