#!/bin/sh
# Runs the roomseg command as a user does: exit codes, messages, output files.
# usage: cli_test.sh PATH_OF_ROOMSEG
. "$(dirname "$0")/checks.sh"

# Two rooms of 3 x 3 m with a door, white or black free.
# plan FREE OCCUPIED
plan() {
    awk -v free="$1" -v occupied="$2" 'BEGIN {
        print "P2\n150 80\n255"
        for (y = 0; y < 80; y++)
            for (x = 0; x < 150; x++) {
                room = y >= 5 && y < 75 && (x >= 5 && x < 70 || x >= 75 && x < 145)
                door = y >= 30 && y < 48 && x >= 70 && x < 75
                print room || door ? free : occupied
            }
    }'
}
plan 0 255 >plan.pgm
plan 254 0 >plan_ros.pgm
cat >plan.yaml <<'END'
image: plan_ros.pgm
resolution: 0.05
origin: [10.0, 20.0, 0.0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
END

# ---- the program itself

run --version
verdict "version: exit 0" [ "$code" -eq 0 ]
verdict "version: a number" grep -Eq '^roomseg [0-9]+\.[0-9]+\.[0-9]+$' stdout
run --help
verdict "help: exit 0" [ "$code" -eq 0 ]
verdict "help: names the commands" grep -q segment stdout
run segment --help
verdict "segment --help: exit 0" [ "$code" -eq 0 ]
verdict "segment --help: explains" grep -q -e --resolution stdout
misused "no command" "which command?"
misused "unknown command" "unknown command 'sweep'" sweep
misused "no map" "which map?" segment -o out
misused "no folder" "-o FOLDER is missing" segment plan.pgm
misused "jobs '0'" "--jobs" segment plan.pgm -o out -j 0
misused "unknown option" "unknown option '--fast'" segment plan.pgm -o out --fast
misused "option without value" "--resolution needs a value" segment plan.pgm -o out --resolution
misused "unknown profile" "unknown profile 'x'" segment plan.pgm -o out --profile x
for value in nan inf -0.05 0 0.019 0.21 0.05m '' 0x1p-4 1e-400; do
    misused "resolution '$value'" "--resolution" segment plan.pgm -o out --resolution "$value"
done
for value in -1 255 1.5 x 10x; do
    misused "free-below '$value'" "--free-below needs" segment plan.pgm -o out --free-below "$value"
done
misused "occupied below free" "is below" segment plan.pgm -o out --free-below 90 --occupied-above 80
verdict "wrong usage writes nothing" [ ! -e out ]

# ---- a map, all the way

run segment plan.pgm --resolution 0.05 -o deep/er/out
verdict "segment: exit 0" [ "$code" -eq 0 ]
verdict "segment: silent on stderr" [ ! -s stderr ]
verdict "segment: finds two rooms" grep -q '^2 rooms' stdout
verdict "segment: tells the arena" grep -Eq '^arena: [0-9]+ bytes .* bytes a cell$' stdout
verdict "segment: tells where" grep -qF 'deep/er/out/{labels.pgm,rooms.json,rooms.png}' stdout
verdict "segment: three files, no others" [ "$(ls -A deep/er/out | tr '\n' ' ')" = \
    "labels.pgm rooms.json rooms.png " ]
verdict "labels: size and depth" [ "$(head -n 3 deep/er/out/labels.pgm | tr '\n' ' ')" = \
    "P5 150 80 255 " ]
verdict "labels: every cell" [ "$(wc -c <deep/er/out/labels.pgm)" -eq $((150 * 80 + 14)) ]
verdict "picture: a PNG" [ "$(od -An -tx1 -N8 deep/er/out/rooms.png | tr -d ' ')" = \
    89504e470d0a1a0a ]
verdict "json: the map's resolution" grep -q '"resolution_m": 0.05,' deep/er/out/rooms.json
verdict "json: both rooms" [ "$(grep -c '"label":' deep/er/out/rooms.json)" -eq 2 ]
cp -R deep/er/out first
run segment plan.pgm --resolution=0.05 -o deep/er/out
verdict "again: the same bytes" diff -r first deep/er/out

run segment plan.yaml -o yaml_out
verdict "yaml: exit 0" [ "$code" -eq 0 ]
verdict "yaml: the same labels" cmp -s first/labels.pgm yaml_out/labels.pgm
verdict "yaml: its origin" grep -qF '"origin": {"m": [10, 20]' yaml_out/rooms.json
run segment plan_ros.pgm --resolution 0.05 --invert -o invert_out
verdict "invert: the same labels" cmp -s first/labels.pgm invert_out/labels.pgm
run segment plan_ros.pgm -o walls_out
verdict "not inverted: the walls are the rooms" [ "$code" -eq 0 ]
verdict "not inverted: other labels" [ "$(cmp -s first/labels.pgm walls_out/labels.pgm; echo $?)" \
    -eq 1 ]
(cd first && "$roomseg" segment ../plan.yaml -o ../from_elsewhere >/dev/null 2>&1)
verdict "yaml: image beside the YAML" cmp -s first/labels.pgm from_elsewhere/labels.pgm
echo 'P2 2 1 255 127 255' >solid.pgm
run segment solid.pgm -o solid_out
verdict "no free cell: exit 0" [ "$code" -eq 0 ]
verdict "no free cell: no rooms" grep -q '^0 rooms' stdout
verdict "no free cell: a picture all the same" [ -s solid_out/rooms.png ]
plan 60 255 >dim.pgm
run segment dim.pgm -o dim_out
verdict "free-below: 60 is not free" grep -q '^0 rooms' stdout
run segment dim.pgm --free-below 60 -o dim_out
verdict "free-below: 60 is free" grep -q '^2 rooms' stdout
cp plan.pgm ./-plan.pgm
run segment -o dash_out -- -plan.pgm
verdict "a map whose name begins with a dash" [ "$code" -eq 0 ]

# ---- a benchmark with another program's labels

mkdir -p plans/one plans/two other/one
cp plan.pgm plans/one/a.pgm
cp plan.pgm plans/one/b.pgm
cp plan.pgm plans/two/a.pgm
run bench plans --resolution 0.05 --reps 1 --labels other
verdict "bench: exit 0" [ "$code" -eq 0 ]
verdict "bench: no column without a reference" [ -z "$(grep refARI stdout)" ]
mv other/two/a.pgm other/two.pgm
rm other/one/b.pgm
run bench plans --set one --resolution 0.05 --reps 1 --reference other
verdict "reference: its rooms and the agreement" grep -Eq '^a .* 2 +100\.00$' stdout
verdict "reference: a map that it lacks" grep -Eq '^b .* - +-$' stdout
verdict "reference: the mean" grep -q 'mean of 1 maps 100.00; least one/a 100.00$' stdout
run bench plans --set two,one --resolution 0.05 --reps 1 --reference other --no-room 2
verdict "reference: one label is no room" grep -Eq '^a .* 1 +100\.00$' stdout
run bench plans --set one --resolution 0.05 --reps 1 --reference other --json
verdict "reference: in JSON" grep -q '"reference": {"under_painting": 0, ' stdout
verdict "reference: its mean in JSON" grep -q '"reference_rooms": 2, "reference_ari": 1}' stdout
run bench plans --profile paper-home --resolution 0.05 --reps 1
verdict "paper-home: exit 0" [ "$code" -eq 0 ]
misused "no-room" "--no-room needs a whole number" bench plans --no-room 0
refused "no reference" "nowhere: is no folder" bench plans --reference nowhere
echo 'P2 2 1 255 1 2' >other/one/b.pgm
run bench plans --set one --resolution 0.05 --reps 1 --reference other
verdict "a reference of another size: exit 1" [ "$code" -eq 1 ]
verdict "a reference of another size: says why" grep -q \
    'other/one/b.pgm: 2x1 cells, but the map has 150x80$' stderr

# ---- bad input

refused "missing map" "missing.png: No such file" segment missing.png -o bad
refused "a folder as map" "first: Is a directory" segment first -o bad
: >empty.png
refused "empty map" "empty.png: the file is empty" segment empty.png -o bad
head -c 9000 plan.pgm >cut.pgm
refused "truncated PGM" "cut.pgm: " segment cut.pgm -o bad
head -c 60 first/rooms.png >cut.png
refused "truncated PNG" "cut.png: the PNG is truncated" segment cut.png -o bad
refused "colour PNG" "rooms.png: the image has colours" segment first/rooms.png -o bad
refused "not a map" "rooms.json:1: " segment first/rooms.json -o bad
sed 's/0.05/.nan/' plan.yaml >nan.yaml
refused "resolution in a YAML" "nan.yaml:2: resolution is not a finite number" \
    segment nan.yaml -o bad
sed '/negate/d' plan.yaml >short.yaml
refused "key missing" "short.yaml: key 'negate' is missing" segment short.yaml -o bad
refused "YAML inverted" "plan.yaml: " segment plan.yaml --invert -o bad
verdict "bad maps write nothing" [ ! -e bad ]

refused "a file as folder" "plan.pgm: cannot make the folder: Not a directory" \
    segment plan.pgm -o plan.pgm
refused "a folder below a file" "plan.pgm: cannot make the folder: Not a directory" \
    segment plan.pgm -o plan.pgm/out
if [ -d /proc/self ]; then
    refused "a folder that cannot be made" "/proc/roomseg: cannot make the folder" \
        segment plan.pgm -o /proc/roomseg
fi
mkdir locked
chmod 555 locked
if [ "$(id -u)" -ne 0 ]; then
    refused "unwritable folder" "locked/labels.pgm: cannot write" segment plan.pgm -o locked
fi
mkdir -p taken/rooms.json
refused "a folder has an output's name" "taken/rooms.json: cannot write: Is a directory" \
    segment plan.pgm -o taken
verdict "nothing unfinished is left" [ -z "$(find . -name '*.tmp')" ]

# A disk that is full after one block: the old files must stay as they were.
cp -R first full
(
    trap '' XFSZ
    ulimit -f 1
    "$roomseg" segment plan.pgm -o full 2>&1 >/dev/null | cat >&3
) 3>full_message
cp full_message stderr
verdict "full disk: one line" one_line
verdict "full disk: says why" grep -q 'full/.*: cannot write: ' stderr
verdict "full disk: old files stay" diff -r first full
if [ -c /dev/full ]; then
    "$roomseg" segment plan.pgm -o full >/dev/full 2>stderr
    code=$?
    verdict "full standard output: exit 1" [ "$code" -eq 1 ]
    verdict "full standard output: says why" grep -q 'standard output: cannot write' stderr
fi

# ---- many maps

mkdir fleet
cp plan.pgm fleet/a.pgm
cp dim.pgm fleet/b.pgm
cp plan.pgm fleet/c.pgm
for jobs in 1 3; do
    run segment fleet/a.pgm cut.pgm fleet/b.pgm missing.png fleet/c.pgm -j $jobs -o fleet_$jobs
    verdict "many maps, $jobs at a time: exit 1" [ "$code" -eq 1 ]
    verdict "many maps, $jobs at a time: each error and the sum" [ "$(wc -l <stderr)" -eq 3 ]
    verdict "many maps, $jobs at a time: errors in order" [ "$(grep -n cut.pgm stderr |
        cut -d : -f 1) $(grep -n missing.png stderr | cut -d : -f 1)" = "1 2" ]
    verdict "many maps, $jobs at a time: sum" grep -q 'fleet_.: 2 of 5 maps failed' stderr
    verdict "many maps, $jobs at a time: in order" [ "$(sed 's/:.*//' stdout | tr '\n' ' ')" = \
        "[1/5] fleet_$jobs/a [3/5] fleet_$jobs/b [5/5] fleet_$jobs/c " ]
done
verdict "many maps: one or three at a time are the same" diff -r fleet_1 fleet_3
run segment fleet/a.pgm -o fleet_single
verdict "many maps: each as if alone" diff -r fleet_single fleet_3/a
run segment fleet/a.pgm fleet/b.pgm -o fleet_two
verdict "two maps: exit 0" [ "$code" -eq 0 ]
verdict "two maps: silent on stderr" [ ! -s stderr ]
refused "two maps of one name" "both would be written to the folder 'plan'" \
    segment plan.pgm plan.yaml -o same
verdict "two maps of one name: nothing written" [ ! -e same ]

for jobs in 1 3; do
    run bench fleet --reps 1 -j $jobs --stages --labels bench_$jobs
    verdict "bench, $jobs at a time: exit 0" [ "$code" -eq 0 ]
    verdict "bench, $jobs at a time: in order" [ "$(sed 's/:.*//' stderr | tr '\n' ' ')" = \
        "[1/3] fleet/a [2/3] fleet/b [3/3] fleet/c " ]
    verdict "bench --stages: a line a stage" grep -Eq '^watershed +[0-9.]+ +[0-9.]+' stdout
done
verdict "bench: one or three at a time are the same" diff -r bench_1 bench_3
run bench fleet --reps 2 --stages --json
verdict "bench --stages --json" grep -q '"stages": {"threshold": {"time_ms": ' stdout
misused "bench: jobs 'x'" "--jobs" bench fleet -j x
cp cut.pgm fleet/b.pgm
run bench fleet --reps 1
verdict "bench: a bad map: exit 1" [ "$code" -eq 1 ]
verdict "bench: a bad map does not stop the others" grep -q '^\[3/3\] fleet/c' stderr

# ---- explain

run explain --help
verdict "explain --help: exit 0" [ "$code" -eq 0 ]
verdict "explain --help: explains" grep -q -e --sheet stdout
misused "explain: no map" "explain: which map?" explain -o out
misused "explain: no folder" "-o FOLDER is missing" explain plan.pgm
misused "explain: map and sheet" "a map does not go with --sheet" \
    explain plan.pgm --sheet . -o out
misused "explain: truth and sheet" "--truth does not go with --sheet" \
    explain --sheet . --truth plan.pgm -o out
misused "explain: config and sheet" "--config does not go with --sheet" \
    explain --sheet . --config speck_mm2=0 -o out
misused "explain: set without sheet" "--set goes with --sheet only" \
    explain plan.pgm --set a -o out
misused "explain: unknown profile" "unknown profile 'x'" explain plan.pgm -o out --profile x
refused "explain: missing map" "missing.png: No such file" explain missing.png -o bad
refused "explain: truncated map" "cut.pgm: " explain cut.pgm -o bad
refused "explain: nothing free" "solid.pgm: no cell is free" explain solid.pgm -o bad
refused "explain: missing truth" "missing.png: No such file" \
    explain plan.pgm --truth missing.png -o bad
refused "explain: truth of another size" "plan.pgm: 150x80 cells, but the truth has 2x1" \
    explain plan.pgm --truth solid.pgm -o bad
refused "explain: bad config" "plan.pgm: cannot be segmented" \
    explain plan.pgm --config room_opening_percent=0 -o bad
refused "explain: sheet of no folder" "missing: cannot read the folder" \
    explain --sheet missing -o bad
refused "explain: no such set" "has no set 'nowhere'" explain --sheet . --set nowhere -o bad
verdict "explain: bad maps write nothing" [ ! -e bad ]
refused "explain: a file as folder" "plan.pgm: cannot make the folder: Not a directory" \
    explain plan.pgm -o plan.pgm
run explain plan.pgm -o explained
verdict "explain: exit 0" [ "$code" -eq 0 ]
verdict "explain: silent on stderr" [ ! -s stderr ]
verdict "explain: ten pictures and the page" [ "$(ls -A explained | wc -l)" -eq 11 ]
cp -R explained explained_before
run explain plan.pgm -o explained
verdict "explain again: the same bytes" diff -r explained_before explained
(
    trap '' XFSZ
    ulimit -f 8
    "$roomseg" explain dim.pgm --config free_max=60 -o explained 2>&1 >/dev/null | cat >&3
) 3>full_message
cp full_message stderr
verdict "explain, full disk: one line" one_line
verdict "explain, full disk: says why" grep -q 'explained/.*: cannot write: ' stderr
verdict "explain, full disk: old files stay" diff -r explained_before explained

checks_end
