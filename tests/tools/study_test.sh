#!/bin/sh
# Runs the study and draws the parameter pictures, both on little; checks what they write.
# usage: study_test.sh PATH_OF_ROOMSEG SOURCE_FOLDER
command -v python3 >/dev/null || {
    echo "skipped: there is no python3"
    exit 77
}
source=$(cd "$2" && pwd) || exit 2
. "$(dirname "$0")/checks.sh"

study() {
    python3 "$source/tools/study.py" "$@" >stdout 2>stderr
    code=$?
}

# Two rooms of 3 x 3 m with a door; the second room begins at column WALL. Prints the map when
# TRUTH is 0, else the rooms.
# plan WALL TRUTH
plan() {
    awk -v wall="$1" -v truth="$2" 'BEGIN {
        print "P2\n150 80\n255"
        for (y = 0; y < 80; y++)
            for (x = 0; x < 150; x++) {
                inside = y >= 5 && y < 75 && x >= 5 && x < 145
                door = y >= 30 && y < 48
                floor = inside && (x != wall || door)
                if (truth)
                    print floor ? (x < wall ? 1 : 2) : 0
                else
                    print floor ? 0 : 255
            }
    }'
}
for wall in 70 80 90; do
    mkdir -p plans/$wall
    plan $wall 0 >plans/$wall/map.pgm
    plan $wall 1 >plans/$wall/truth.pgm
done

study "$roomseg" plans --seeds 1 --jobs 1 -o out/study.md --json figures.json
verdict "study: exit 0" [ "$code" -eq 0 ]
verdict "study: tells where" grep -qx "written: out/study.md" stdout
verdict "study: shows how far it is" grep -q '^validation: [0-9]* of [0-9]*$' stderr
verdict "study: four parts" [ "$(grep -c '^## ' out/study.md)" -eq 4 ]
verdict "study: these rooms are easy" grep -Eq \
    '^\| nothing \|  \| (98|99|100)\.[0-9]* \|' out/study.md
verdict "study: picks hold on maps left out" grep -q '0.00 points below tuned.*, met' out/study.md
verdict "study: turned rooms" grep -Eq '^\| turned by 17 degrees .* 96.5: met \|$' out/study.md
verdict "study: simulated homes" grep -q '^| all furnished | 3 | ' out/study.md
verdict "study: figures as JSON" python3 -c 'import json
assert json.load(open("figures.json"))["validation"]["leave_one_out"] > 0.98'
verdict "study: nothing unfinished is left" [ -z "$(find . -name '*.tmp')" ]
verdict "study: nothing in the source tree" [ ! -e "$source/tools/study_parts/__pycache__" ]
cp out/study.md first.md
study "$roomseg" plans --seeds 1 --jobs 2 -o out/study.md
verdict "study: the same again" cmp -s first.md out/study.md

study "$roomseg" missing -o missing.md
verdict "no data set: exit 1" [ "$code" -eq 1 ]
verdict "no data set: says why" grep -q 'missing: .*No such file' stderr
mkdir bare && cp plans/70/map.pgm bare
study "$roomseg" bare -o missing.md
verdict "no truth: exit 1" [ "$code" -eq 1 ]
verdict "no truth: says why" grep -q 'bare: no map has a truth' stderr
study ./missing plans -o missing.md
verdict "no command: exit 1" [ "$code" -eq 1 ]
study "$roomseg" plans --parts homes,castles -o missing.md
verdict "unknown part: exit 2" [ "$code" -eq 2 ]
study "$roomseg" plans --seeds 0 -o missing.md
verdict "no seeds: exit 2" [ "$code" -eq 2 ]
verdict "failures write nothing" [ ! -e missing.md ]

python3 "$source/tools/parameter_pictures.py" "$roomseg" pictures >stdout 2>stderr
verdict "pictures: exit 0" [ "$?" -eq 0 ]
for picture in $(sed -n 's/^!\[.*](parameters\/\(.*\))$/\1/p' "$source/docs/parameters.md"); do
    verdict "pictures: $picture" [ "$(od -An -tx1 -N8 "pictures/$picture" | tr -d ' ')" = \
        89504e470d0a1a0a ]
    verdict "pictures: $picture is in docs" [ -s "$source/docs/parameters/$picture" ]
    rm -f "pictures/$picture"
done
verdict "pictures: all of them are in the text" [ -z "$(ls pictures)" ]
for field in $("$roomseg" bench plans --json 2>/dev/null |
    sed -n 's/^ "config": {\(.*\)},*$/\1/p' | tr ',' '\n' | sed 's/.*"\(.*\)".*/\1/'); do
    verdict "docs/parameters.md explains $field" grep -q "\`$field\`" "$source/docs/parameters.md"
done

checks_end
