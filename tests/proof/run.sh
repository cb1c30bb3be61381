#!/bin/sh
# Proves with CBMC what tests/proof/prove_*.c says, and that no run-time error can happen on the
# way: index out of bounds, overflow, shift, division by zero, conversion that loses bits.
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

words=$(echo "$*" | tr ' ' '|')
printf '%-7s %5s %5s  %-28s %-46s %s\n' "" goals time function \
    "proved, beside no run-time error" ranges
prove base isqrt 18 exact rs_isqrt "result <= 65535" "all 32-bit n"
prove base isqrt_value 18 exact rs_isqrt "root^2 <= n < (root + 1)^2" "n < 2^16"
prove base divide_q8 73 wraps rs_divide_q8 "-" "quotient < 2^32"
prove base ticker_call 10 exact rs_ticker_call "0..1000, never falls" "done <= total < 2^29"
prove trig direction 6 exact rs_trig_direction "-1..1" "-720..720 degrees"
prove trig angle 15 exact rs_trig_angle "-180..180 degrees" "|x|, |y| < 2^31"
prove distance crossing 1 exact crossing "-" "columns < 2^16, heights <= 255^2"
prove blur box 64 exact rs_box_of_variance "weights sum to 2^16, radius <= 62" \
    "all 32-bit variances"
prove heap heap 8 exact "rs_heap_push, _pop" "sorted, nothing lost" "6 items"
prove components add_area 1 exact add_area "saturates" "both <= 2^30"
prove components runs 10 exact find_runs "maximal, ordered, as few as planned" "rows of 8 cells"
prove join openness 1 exact openness "<= 327,680,000" "distances 1..255, 1..100 percent"
prove join niche 1 exact niche_key "<= 16384" "distances 1..255, any area"
prove plan plan 1 wraps ROOMSEG_PLAN_TABLE "all buffers fit in 32 bits" "all sizes and capacities"
prove plan plan_small 1 exact ROOMSEG_PLAN_SMALL "<= 10001 cells" "all configs, 20..200 mm"
exit $failed
