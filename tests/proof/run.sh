#!/bin/sh
# Proves with CBMC what tests/proof/prove_*.c says, and that no run-time error can happen on the
# way: index out of bounds, overflow, shift, division by zero, conversion that loses bits. What
# CBMC does not decide in time and has few enough cases is tried out, case by case
# (tests/proof/exhaust.c).
#
#   tests/proof/run.sh [WORD...]    only the proofs whose line in the table has one of the words
#
# Prints a table. Exit code 1 when a proof fails or takes more than 5 minutes.
set -eu

cd "$(dirname "$0")/../.."
tests/proof/get_cbmc.sh
if command -v cbmc >/dev/null 2>&1; then cbmc=cbmc; else cbmc=build/cbmc/run; fi
mkdir -p build/proof
failed=0

# Modular arithmetic is meant where unsigned numbers may wrap: those proofs say "wraps".
prove() { # FILE PROOF UNWIND CHECKS FUNCTION "WHAT IS PROVED" "RANGES"
    [ -z "$words" ] || printf '%s\n' "$*" | grep -qwE "$words" || return 0
    checks="--bounds-check --pointer-check --signed-overflow-check --undefined-shift-check
        --div-by-zero-check --pointer-overflow-check"
    [ "$4" = wraps ] || checks="$checks --unsigned-overflow-check"
    log=build/proof/$2.log
    begin=$(date +%s)
    # shellcheck disable=SC2086 # words
    if timeout 300 $cbmc "tests/proof/prove_$1.c" -I include -I src --function "prove_$2" \
        --unwind "$3" --unwinding-assertions $checks >"$log" 2>&1; then
        verdict=proved
    else
        verdict=FAILED
        failed=1
    fi
    count=$(sed -n 's/^\*\* [0-9]* of \([0-9]*\) failed.*/\1/p' "$log")
    printf '%-7s %5s %4ss  %-28s %-46s %s\n' "$verdict" "${count:--}" \
        $(($(date +%s) - begin)) "$5" "$6" "$7"
}

# Under sanitizers, but for what takes a minute without.
try_all() { # WORD FUNCTION "WHAT IS PROVED" "RANGES"
    [ -z "$words" ] || printf '%s\n' "$*" | grep -qwE "$words" || return 0
    sanitize="-fsanitize=address,undefined -fno-sanitize-recover=all"
    [ "$1" != isqrt ] || sanitize=
    begin=$(date +%s)
    # shellcheck disable=SC2086 # words
    if gcc -std=c99 -O2 $sanitize -Iinclude -Isrc tests/proof/exhaust.c -o build/proof/exhaust &&
        build/proof/exhaust "$1" >"build/proof/try_$1.log" 2>&1; then
        verdict=tried
    else
        verdict=FAILED
        failed=1
    fi
    printf '%-7s %5s %4ss  %-28s %-46s %s\n' "$verdict" - $(($(date +%s) - begin)) "$2" "$3" "$4"
}

words=$(echo "$*" | tr ' ' '|')
printf '%-7s %5s %5s  %-28s %-46s %s\n' "" goals time function \
    "proved, beside no run-time error" ranges
prove base isqrt 18 exact rs_isqrt "result <= 65535" "all 32-bit n"
prove base isqrt_value 18 exact rs_isqrt "root^2 <= n < (root + 1)^2" "n < 2^16"
prove base divide_q8 73 wraps rs_divide_q8 "-" "quotient < 2^32"
prove base ticker_call 10 exact rs_ticker_call "0..1000, never falls" "done <= total < 2^29"
prove trig direction 6 exact rs_trig_direction "-1..1" "-720..720 degrees"
prove trig angle 15 exact rs_trig_angle "-180..180 degrees" "|x|, |y| < 2^31"
prove distance crossing 18 wraps crossing "-" "columns < 2^16, heights <= 255^2"
prove blur box 64 exact rs_box_of_variance "weights sum to 2^16, radius <= 62" \
    "all 32-bit variances"
prove heap heap 8 exact "rs_heap_push, _pop" "sorted, nothing lost" "6 items"
prove ring ring_push 10 exact rs_ring_push "appended, all else stays; false iff full" \
    "any state of a ring of 1..9"
prove ring ring_pop 10 exact rs_ring_pop "the oldest; the others stay in order" \
    "any state of a ring of 1..9"
prove components add_area 1 exact add_area "saturates" "both <= 2^30"
prove components runs 10 exact find_runs "maximal, ordered, as few as planned" "rows of 8 cells"
prove join openness 1 exact openness "<= 327,680,000" "distances 1..255, 1..100 percent"
prove join niche 1 exact niche_key "<= 16384" "distances 1..255, any area"
prove plan plan 1 wraps ROOMSEG_PLAN_TABLE "all buffers fit in 32 bits" "all sizes and capacities"
prove plan plan_small 1 exact ROOMSEG_PLAN_SMALL "<= 10001 cells" "all configs, 20..200 mm"
try_all isqrt rs_isqrt "floor of the root" "all 2^32"
try_all tangent rs_trig_angle "finds the greatest angle not too steep" "all angles of an octant"
try_all crossing crossing "first column where b is below a" "all heights, gaps of 1..300, some widths"
try_all queue "rs_queue_push, _pop" "each list in order; refused iff no block is left" \
    "2 lists, 2 blocks: any 11 steps"
try_all cluster "rs_cluster_root, _unite" "one root iff connected; area, peak" \
    "any 4 unions of 4 regions"
exit $failed
