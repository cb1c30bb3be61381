#!/bin/sh
# Input that means harm, or that nobody thought of: the command ends with one clear line and exit
# code 1, soon, and writes nothing, or it does its work.
# usage: hostile_test.sh PATH_OF_ROOMSEG
. "$(dirname "$0")/checks.sh"

# harmless NAME MESSAGE ARGUMENT...: refused, and no output files
harmless() {
    refused "$@"
    verdict "$1: no files" [ ! -e out ]
}

# accepted NAME ARGUMENT...
accepted() {
    name=$1
    shift
    run "$@"
    verdict "$name: exit 0" [ "$code" -eq 0 ]
    rm -rf out
}

image() { # WIDTH HEIGHT BYTE: a PGM of one value
    printf 'P5 %d %d 255\n' "$1" "$2"
    head -c $(($1 * $2)) /dev/zero | tr '\000' "$3"
}

# ---- sizes
image 100000 1 '\000' >wide.pgm
harmless "100,000 x 1" "100000 x 1 cells are too many" segment wide.pgm -o out
image 65535 1 '\000' >wide.pgm
harmless "wider than the library takes" "wide.pgm: " segment wide.pgm -o out
image 1 65534 '\000' >high.pgm
harmless "higher than the library takes" "high.pgm: " segment high.pgm -o out
image 65533 1 '\000' >wide.pgm
accepted "as wide as it gets" segment wide.pgm -o out
image 1 1 '\000' >one.pgm
accepted "one free cell" segment one.pgm -o out
accepted "one free cell, turned" segment one.pgm --align -o out
accepted "one free cell, the paper's way" segment one.pgm --profile paper -o out
printf 'P5 999999999 999999999 255\n' >vast.pgm
harmless "sizes whose product overflows" "too many" segment vast.pgm -o out
printf 'P5 4294967296 1 255\na' >vast.pgm
harmless "a width beyond 32 bits" "holds no width" segment vast.pgm -o out

# ---- things that are no files
mkdir folder
harmless "a folder as map" "folder: Is a directory" segment folder -o out
harmless "an empty file" "/dev/null: the file is empty" segment /dev/null -o out
yaml() { # IMAGE
    printf 'image: %s\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n' "$1"
    printf 'occupied_thresh: 0.65\nfree_thresh: 0.2\n'
}
yaml self.yaml >self.yaml
harmless "a YAML that is its own image" "neither a PNG nor a PGM" segment self.yaml -o out
yaml folder >dir.yaml
harmless "a YAML whose image is a folder" "folder: Is a directory" segment dir.yaml -o out
yaml /dev/null >null.yaml
harmless "a YAML whose image is empty" "/dev/null: the file is empty" segment null.yaml -o out
yaml ../../../../../../no/such >far.yaml
harmless "a YAML whose image is far away" "No such file" segment far.yaml -o out
head -c 70000 /dev/zero | tr '\000' '#' >long.yaml
harmless "a text without end" "neither a PNG or PGM image nor" segment long.yaml -o out
ln -s loop loop
harmless "a link to itself" "loop: " segment loop -o out
long=$(head -c 255 /dev/zero | tr '\000' n)
harmless "a name without a file" "No such file" segment "$long" -o out
harmless "a name that is too long" "File name too long" segment "n$long" -o out
harmless "line breaks in a name" "No such file" segment "$(printf 'a\nb\033[2J')" -o out
verdict "control characters do not get through" [ "$(tr -d '\012\040-\176' <stderr | wc -c)" -eq 0 ]

# ---- other commands
image 4 4 '\001' >labels.pgm
image 4 5 '\001' >other.pgm
image 4 4 '\000' >zero.pgm
harmless "labels of another size" "labels.pgm: " eval --labels labels.pgm --truth other.pgm
harmless "a truth without rooms" "holds no room" eval --labels labels.pgm --truth zero.pgm
harmless "labels that are missing" "No such file" eval --labels none --truth zero.pgm
harmless "a truth that is a folder" "Is a directory" eval --labels labels.pgm --truth folder
accepted "labels without rooms" eval --labels zero.pgm --truth labels.pgm
harmless "a data set without maps" "folder" bench folder
harmless "a data set that is a file" "one.pgm" bench one.pgm
mkdir bad && cp vast.pgm bad/map.pgm
run bench bad
verdict "a data set with a bad map: exit 1" [ "$code" -eq 1 ]
verdict "a data set with a bad map: names it" grep -q '^roomseg: bad/map.pgm: ' stderr
harmless "a simulated flat in a file" "Not a directory" simulate --seed 1 -o one.pgm

# ---- outputs that cannot be written
if [ -c /dev/full ]; then
    for command in "eval --labels labels.pgm --truth labels.pgm" "--help" "--version"; do
        # shellcheck disable=SC2086 # words
        "$roomseg" $command >/dev/full 2>stderr
        verdict "$command, full standard output: exit 1" [ $? -eq 1 ]
    done
fi
"$roomseg" eval --labels labels.pgm --truth labels.pgm >&- 2>stderr
verdict "closed standard output: exit 1" [ $? -eq 1 ]

# ---- killed at any moment: an output is missing or whole, an old one stays or is replaced whole
image 700 700 '\000' >square.pgm
run segment square.pgm -o whole
for step in 0 1 2 3 4 5 6 7 8 9; do
    "$roomseg" segment square.pgm -o killed >stdout 2>stderr &
    process=$!
    sleep 0.00$step
    kill -KILL $process 2>kill_stderr
    wait $process 2>wait_stderr
    for file in labels.pgm rooms.png rooms.json; do
        [ ! -e killed/$file ] || cmp -s killed/$file whole/$file || {
            echo "killed/$file differs" >stderr
            verdict "killed after 0.00$step s: whole files" false
        }
    done
done
verdict "killed: whole files or none" true
rm -f killed/*.tmp
run segment square.pgm -o killed
verdict "killed, then run again" diff -r whole killed

checks_end
