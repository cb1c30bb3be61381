# What the tests of the command share. Sourced, with the path of roomseg as the first argument:
# goes to a folder of the test's own, which is removed at the end. checks_end comes last.
case ${1:-} in
/*) roomseg=$1 ;;
*) roomseg=$PWD/${1:-} ;;
esac
[ -f "$roomseg" ] && [ -x "$roomseg" ] || {
    sed -n 's/^# usage/usage/p' "$0" >&2
    exit 2
}
LC_ALL=C
export LC_ALL
work=$(mktemp -d) || exit 1
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
trap 'exit 1' HUP INT TERM
cd "$work" || exit 1
failures=0

# verdict NAME CONDITION...: the condition is a command; one line a check
verdict() {
    name=$1
    shift
    if "$@"; then
        echo "ok: $name"
    else
        echo "FAILED: $name ($*)"
        sed 's/^/    stdout: /' stdout | head -n 5
        sed 's/^/    stderr: /' stderr | tail -n 5
        failures=$((failures + 1))
    fi
}

# run ARGUMENT...: leaves stdout, stderr and the exit code
run() {
    "$roomseg" "$@" >stdout 2>stderr
    code=$?
}

one_line() {
    [ "$(wc -l <stderr)" -eq 1 ]
}

# refused NAME MESSAGE ARGUMENT...: bad input, one line that holds the message
refused() {
    name=$1
    message=$2
    shift 2
    run "$@"
    verdict "$name: exit 1" [ "$code" -eq 1 ]
    verdict "$name: one line" one_line
    verdict "$name: says why" grep -qF -e "$message" stderr
}

# misused NAME MESSAGE ARGUMENT...: wrong usage, the message and a hint
misused() {
    name=$1
    message=$2
    shift 2
    run "$@"
    verdict "$name: exit 2" [ "$code" -eq 2 ]
    verdict "$name: says why" grep -qF -e "$message" stderr
    verdict "$name: shows the usage" grep -q '^usage: roomseg' stderr
}

checks_end() {
    echo "$failures failed"
    [ "$failures" -eq 0 ]
}
