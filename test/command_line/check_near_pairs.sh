#!/usr/bin/env bash
# Copyright (c) 2026 The Thick_intersection_d authors.
# SPDX-License-Identifier: LGPL-3.0-or-later
#
# Checks the command line of the example near_pairs on small files that it writes itself, and on the
# ship positions of examples/data.
#
#   check_near_pairs.sh BINARY DATA_DIR
#
# Prints a line per check and a count at the end; the status is 1 if a check failed.

set -u

if [ $# -ne 2 ]; then
  echo "usage: $0 BINARY DATA_DIR" >&2
  exit 2
fi
if [ ! -x "$1" ] || [ ! -d "$2" ]; then
  echo "$0: $1 is no program, or $2 no directory" >&2
  exit 2
fi
binary=$(realpath "$1")
data=$(realpath "$2")
version=$(sed -nE 's/^#define CGAL_THICK_INTERSECTION_D_VERSION "(.*)"$/\1/p' \
            "$(dirname "$0")/../../include/CGAL/Thick_intersection_d/version.h")
ships=$data/ships_us_2022-01-03.csv
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
cd "$directory" || exit 2

# A check that is called by a wrong name is no check.
command_not_found_handle() {
  echo "FAILED  there is no command $1" >&2
  kill $$
}

passed=0
failed=0

# verdict NAME TEST...: runs a test command and counts it.
verdict() {
  local name=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
    echo "ok      $name"
  else
    failed=$((failed + 1))
    echo "FAILED  $name"
    sed 's/^/        stdout: /' out | head -n 5
    sed 's/^/        stderr: /' err | head -n 5
  fi
}

# run ARGUMENT...: runs the program; what it printed is in the files out and err. None of the small
# files takes a second: a program that takes a minute takes time that is not linear in their size.
run() {
  timeout 300 "$binary" "$@" > out 2> err
  status=$?
}

# summary NAME: the value of a line of the summary.
summary() {
  sed -n "s/^$1  *//p" out
}

# The program must end well, with this number of pairs.
expect_pairs() { # NAME PAIRS ARGUMENT...
  local name=$1 pairs=$2
  shift 2
  run "$@"
  verdict "$name: $pairs pairs" test "$status $(summary pairs)" = "0 $pairs"
}

# The program must end well, with this pair at this squared distance.
expect_closest() { # NAME PAIR SQUARED ARGUMENT...
  local name=$1 pair=$2 squared=$3
  shift 3
  run "$@" --closest
  verdict "$name: closest pair $pair" test "$status $(summary 'closest pair')" = "0 $pair"
  verdict "  at squared distance $squared" test "$(summary squared)" = "$squared, exactly"
}

expect_boundary() { # PAIRS
  verdict "  of them on the boundary: $1" test "$(summary 'on boundary')" = "$1"
}

is_one_error() { # MESSAGE
  [ "$status" -eq 2 ] && [ "$(wc -l < err)" -eq 1 ] && [ ! -s out ] &&
    [ "$(head -c 12 err)" = "near_pairs: " ] && grep -qF -- "$1" err
}

# The program must end with status 2, exactly one line on stderr that has the message, and no output.
expect_error() { # NAME MESSAGE ARGUMENT...
  local name=$1 message=$2
  shift 2
  rm -f none.csv none.svg
  run "$@" --pairs none.csv --picture none.svg
  verdict "$name: $message" is_one_error "$message"
  verdict "  and leaves no file" test -z "$(ls -A | grep -E 'none|part')"
}

sorted_pairs() { # FILE
  tail -n +2 "$1" | cut -d, -f1,2 | sort
}

same_pairs() { # FILE FILE
  [ "$(sorted_pairs "$1")" = "$(sorted_pairs "$2")" ]
}

# ---------------------------------------------------------------- small scenes

{ echo x,y; for i in $(seq 0 99); do echo "$((i / 10)).$((i % 10)),0"; done; } > ties.csv
printf 'x,y\n0,0\n2,3\n3,2\n10,10\n' > thirteen.csv
printf 'x,y\n0,0\n1,0\n3,0\n' > thirds.csv
printf 'id,x,y,z,note\n"a, b",0,0,0,"says ""hi"""\nc,1,0,0,"two\nlines"\nd,1,1,5,\n' > quoted.csv
printf 'x,y\n' > empty.csv
printf 'x,y\nN/A,0\n' > gaps_na.csv
printf 'x,y\n0,0\n,\n1,1\n' > thirds_gap.csv
printf 'name,e,n,h\nP,0,0,0\nQ,0,0,9\nR,5,5,5.6\n' > other_names3.csv
printf 'lat,lon\n60,10\n60,10.02\n' > lon_last.csv
printf 'y,x\n60,10\n60,10.01\n' > x_and_y.csv
printf 'x,y\n0,0\n1,oops\n' > word.csv
printf 'x,y\n0,0\n1,-inf\n' > infinite.csv
printf 'x,y\n1,2\n' > single.csv
printf 'x,y\n7,7\n7,7\n7,7\n' > equal.csv
printf '\xEF\xBB\xBFx,y\r\n0,0\r\n1,0\r\n' > windows.csv
printf 'Latitude,Longitude\n90,0\n90,120\n0,179.9999999\n0,-179.9999999\n' > globe.csv
printf '# two close points\n0 0 0 label\n\n\t0.5 0 0\n5 5 5\n' > points.xyz
printf 'OFF\n3 0 0\n0 0 0\n0.5 0 0\n5 5 5\n' > points.off
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n%s\n' \
       $'property double z\nend_header\n0 0 0\n0.5 0 0\n5 5 5' > points.ply
printf 'NAME : t\nTYPE : TSP\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n%s\n' \
       $'1 0 0\n2 5e-1 0\n3 5 5\nEOF' > points.tsp

expect_pairs "tenths as decimals, closed" 99 ties.csv --decimal --distance 0.1
expect_boundary 99
expect_pairs "tenths as decimals, open" 0 ties.csv --decimal --distance 0.1 --open
expect_pairs "tenths as decimals, distance 1/10" 99 ties.csv --decimal --distance 1/10
expect_pairs "tenths as decimals, distance 1e-1" 99 ties.csv --decimal --distance 1e-1
expect_pairs "tenths as decimals, a hair less" 0 ties.csv --decimal --distance 0.0999999999999999999999
expect_pairs "tenths as decimals, squared distance" 99 ties.csv --decimal --squared-distance 0.01
run ties.csv --distance 0.1
verdict "tenths as doubles are not all within one tenth" test "$status" -eq 0 -a "$(summary pairs)" -lt 99

# The same from the definition: a double is within the tenth if its exact difference is.
doubles=$(python3 - << 'END' 2> /dev/null
from fractions import Fraction
x = [Fraction(float("%d.%d" % (i // 10, i % 10))) for i in range(100)]
print(sum(b - a <= Fraction(1, 10) for a, b in zip(x, x[1:])))
END
)
if [ -n "$doubles" ]; then
  verdict "  but $doubles of them are" test "$(summary pairs)" = "$doubles"
fi

expect_pairs "squared distance 13" 3 thirteen.csv --squared-distance 13
expect_boundary 2
expect_pairs "squared distance 13, open" 1 thirteen.csv --squared-distance 13 --open
expect_pairs "distance as a quotient" 1 thirds.csv --distance 3/3
expect_boundary 1
expect_pairs "distance just below one" 0 thirds.csv --distance 999999999999999999999/1000000000000000000000
expect_pairs "no points" 0 empty.csv --distance 1
expect_pairs "one point" 0 single.csv --distance 1
expect_pairs "equal points at distance 0" 3 equal.csv --distance 0
expect_boundary 3
expect_pairs "byte order mark and CRLF" 1 windows.csv --distance 1
expect_pairs "the pole and the antimeridian are no borders" 2 globe.csv --geographic --distance 0.1
expect_pairs ".xyz" 1 points.xyz --distance 0.5
expect_pairs ".off" 1 points.off --distance 0.5
expect_pairs ".ply" 1 points.ply --distance 0.5
expect_pairs ".tsp" 1 points.tsp --distance 0.5
expect_pairs "in space the third axis counts" 1 quoted.csv --distance 2
expect_pairs "in the plane it does not" 3 quoted.csv --distance 2 --dimension 2
expect_pairs "columns by number" 1 quoted.csv --distance 1 --columns 2,4
expect_pairs "columns by name, in upper case" 1 quoted.csv --distance 1 --columns Y,Z

# ---------------------------------------------------------------- tables, pipes and other formats

# The program must end well, with this number of points and pairs.
expect_scene() { # NAME POINTS PAIRS ARGUMENT...
  local name=$1 points=$2 pairs=$3
  shift 3
  run "$@"
  verdict "$name: $points points, $pairs pairs" \
          test "$status $(summary points) $(summary pairs)" = "0 $points $pairs"
}

printf 'x;y\n0;0\n1;0\n' > semicolons.csv
printf '"a;b";x;y\n1,5;0;0\n2,5;1;0\n' > quoted_semicolon.csv
printf 'note\tx\ty\n\t0\t0\na b, c; d\t1\t0\n' > tabs.tsv
printf '  x   "y"\n 0 0\n\t1 \t "0" \n' > blanks.txt
printf 'x|y\n0|0\n1|0\n' > bars.csv
printf '# made by hand\nx,y\n# the rest\n0,0\n\n  # is near\n1,0\n' > comments.csv
printf '# by hand\n# id x y\n7 0 0\n8 1 0\n' > comment_header.txt
printf '# two near points\n0 0 0\n1 0 0\n' > comment_words.txt
printf '0,0\n1,0\n5,5\n' > bare.csv
printf 'a,0,0\nb,1,0\nc,5,5\n' > bare_names.csv
printf 'id,2019,2020\na,0,0\nb,1,0\n' > years.csv
printf '7,0,0,1\n8,1,0,1\n' > four.csv
printf 'v 0 0\n' > short.obj
printf 'ATOM      1  N   THR A   1      17.047 -14.099   3.62' > short.pdb
printf 'ATOM      1  N   THR A   1      17.047-114.O99   3.625' > word.pdb
printf 'NODE_COORD_SECTION\n\n1 0 0\n \n2 1 0\n\nEOF\n' > gaps.tsp
printf 'LASF' > cloud.laz
printf 'flat,re_lat,re_lon,longer\n1,0,0,1\n1,0,1,9\n' > words.csv
printf '# mesh\nvn 0 0 1\nv 0 0 0\nv\t0.5 0 0 1.0 9 9\nv 5 5 5\nvt 0 0\nf 1 2 3\n' > points.obj
{ printf 'HEADER    TWO MODELS\n'
  for model in 1 2; do
    printf 'MODEL     %4d\n' $model
    printf 'ATOM      1  N   THR A   1      17.047-114.099   3.625  1.00 13.79           N\n'
    printf 'HETATM99999  CA  THR A   1      17.047-114.099   4.125\nTER\nENDMDL\n'
  done; } > points.pdb

expect_scene "semicolons" 2 1 semicolons.csv --distance 1
expect_scene "  more than decimal commas" 2 1 quoted_semicolon.csv --distance 1
expect_scene "tabs, and an empty field" 2 1 tabs.tsv --distance 1
expect_scene "blanks" 2 1 blanks.txt --distance 1
expect_scene "a separator of one's own" 2 1 bars.csv --distance 1 --separator '|'
expect_scene "  and one that is given" 2 1 tabs.tsv --distance 1 --separator tab
expect_scene "comments" 2 1 comments.csv --distance 1
expect_scene "no header" 3 1 bare.csv --distance 1
expect_scene "  and columns by number" 3 1 bare.csv --distance 1 --columns 2,1
expect_scene "  which leave a name out" 3 1 bare_names.csv --distance 1 --columns 2,3
expect_scene "  and it is said" 3 1 bare_names.csv --distance 1 --columns 2,3 --no-header
expect_scene "a header of numbers" 2 1 years.csv --distance 1 --columns 2019,2020
expect_scene "a comment as the header" 2 1 comment_header.txt --distance 1
verdict "  has the names of the points" test "$(run comment_header.txt --closest; summary 'closest pair')" \
        = "0 1, 7 and 8"
expect_scene "a comment of as many words" 2 1 comment_words.txt --distance 1
expect_scene "coordinates of the first columns" 2 0 four.csv --distance 0.5 --dimension 2
expect_scene "degrees in later words" 2 1 words.csv --distance 1
run bare_names.csv --distance 1 --columns 2,3 --id 1 --pairs pairs.csv
printf 'i,j,id_i,id_j,distance\n0,1,a,b,1\n' > expected
verdict "a column of names" cmp -s pairs.csv expected
expect_scene ".obj" 3 1 points.obj --distance 0.5
expect_scene "blank lines in .tsp" 2 1 gaps.tsp --distance 1
expect_scene ".pdb, one model" 2 1 points.pdb --distance 0.5
run points.pdb --closest
verdict "  with serial numbers" test "$(summary 'closest pair')" = "0 1, 1 and 99999"

expect_scene "the standard input" 100 99 - --decimal --distance 0.1 < ties.csv
expect_scene "  in another format" 3 1 - --format .XYZ --distance 0.5 < points.xyz
expect_scene "a pipe, read twice" 100 99 <(cat ties.csv) --format csv --decimal --distance 0.1
gzip -c ties.csv > ties.csv.gz
{ gzip -c < ties.csv; echo 100,0 | gzip -c; } > two.csv.gz
head -c -20 ties.csv.gz > cut.csv.gz
head -c 5 ties.csv.gz > head.csv.gz
{ head -c -8 ties.csv.gz; head -c 8 /dev/zero; } > damaged.csv.gz
cp ties.csv plain.csv.gz
expect_scene "compressed" 100 99 ties.csv.gz --decimal --distance 0.1
expect_scene "  in two members" 101 99 two.csv.gz --decimal --distance 0.1
expect_scene "  from the standard input" 100 99 - --decimal --distance 0.1 < ties.csv.gz
expect_scene "  in name only" 100 99 plain.csv.gz --decimal --distance 0.1
for file in cut damaged head; do
  expect_error "compressed, $file" "$file.csv.gz: cannot be read to its end" $file.csv.gz --distance 1
done
head -c 5 ties.csv.gz > head.geojson
expect_error "  as GeoJSON" "head.geojson: cannot be read to its end" head.geojson --distance 1
expect_error "an empty standard input" "-: is empty" - --distance 1 < /dev/null
expect_error "a point that is no header" "with --no-header if this is a point" bare_names.csv --distance 1
expect_error "four fields and no header" "four.csv:1: no header, and 4 fields" four.csv --distance 1
expect_error "no such column without a header" "no column '3' among 1 to 2" bare.csv --columns 1,3 --no-header --distance 1
expect_error "a long separator" "--separator: '::'" bare.csv --separator :: --distance 1
expect_error "an option for tables" "--id needs a table" points.obj --id 1 --distance 1
expect_error "short vertex" "short.obj:1: 2 numbers" short.obj --distance 1
expect_error "short atom" "short.pdb:1: the line of an atom ends" short.pdb --distance 1
expect_error "no number in .pdb" "word.pdb:1: y: '-114.O99'" word.pdb --distance 1
expect_error "points from a laser" "'pdal translate' makes a .csv" cloud.laz --distance 1
expect_error "a format that nobody knows" "unknown format" ties.csv --format xls --distance 1

# The table of the README has the number of points of each file.
for file in "$data"/*; do
  name=$(basename "$file")
  [ "$name" = README.md ] && continue
  points=$(awk -F '|' -v name="\`$name\`" '$2 ~ name { gsub(/[ ,]/, "", $5); print $5 }' "$data/README.md")
  columns=() # a runway has two ends
  [ "$name" = runways.csv ] && columns=(--columns le_longitude_deg,le_latitude_deg)
  run "$file" --distance 0.001 "${columns[@]}"
  verdict "$name is read as it is" test "$status $(summary points)$(summary features)" = "0 $points"
done

# ---------------------------------------------------------------- two files

printf 'id,x,y\n"a, b",0,0\nc,0.1,0\n' > named.csv
printf '0 0.3\n0.1 0.003\n0.1 0\n' > plane.txt
expect_scene "two files" "2 and 3" 4 named.csv plane.txt --distance 0.2
printf '0,1,"a, b",,0.1000449899\n0,2,"a, b",,0.1\n1,1,c,,0.003\n1,2,c,,0\ni,j,id_i,id_j,distance\n' > expected
run named.csv plane.txt --distance 0.2 --pairs pairs.csv
sort pairs.csv > sorted
verdict "  positions are those of the files" cmp -s sorted expected
expect_scene "  as decimals, of one scale" "2 and 3" 3 named.csv plane.txt --distance 0.1 --decimal
expect_boundary 1
expect_scene "  with exact numbers" "2 and 3" 3 named.csv plane.txt --distance 0.1 --decimal --kernel exact
expect_scene "  in formats of their own" "3 and 3" 3 points.off points.xyz --distance 0.4
expect_scene "a file with itself" "3 and 3" 9 equal.csv equal.csv --distance 0
expect_scene "a file without points" "0 and 3" 0 empty.csv equal.csv --distance 0
expect_scene "  as the second" "3 and 0" 0 equal.csv empty.csv --distance 0
expect_scene "  and the standard input" "3 and 3" 9 equal.csv - --distance 0 < equal.csv
head -n 5001 "$ships" > first_ships.csv
{ head -n 1 "$ships"; tail -n +5002 "$ships"; } > other_ships.csv
run first_ships.csv --decimal --distance 0.00069
within=$(summary pairs)
run other_ships.csv --decimal --distance 0.00069
within=$((within + $(summary pairs)))
expect_pairs "all pairs of ships but those within a file" $((4931 - within)) \
             first_ships.csv other_ships.csv --decimal --distance 0.00069 --picture picture.svg
verdict "  the picture has both" grep -q 'point of other_ships.csv' picture.svg
expect_error "files in the plane and in space" "points.xyz: has 3 coordinates, and ties.csv has 2" ties.csv points.xyz --distance 1
expect_error "the standard input twice" "can be read only once" - - --distance 1

# ---------------------------------------------------------------- files as they are

printf 'id;x;y\nA;0,5;1\nB;1,25;1\nC;9;1e0\n' > commas_in_numbers.csv
printf '0,5;1\n1,25;1\n' > commas_bare.csv
printf '"x","y"\n"0,5","1"\n"1,25","1"\n' > commas_quoted.csv
printf 'x;y\n0,5;1.5\n' > comma_and_point.csv
expect_scene "numbers with commas" 3 1 commas_in_numbers.csv --distance 0.75 --comma-numbers
expect_boundary 1
expect_scene "  as decimals" 3 1 commas_in_numbers.csv --distance 3/4 --comma-numbers --decimal
expect_scene "  without a header" 2 1 commas_bare.csv --distance 0.75 --comma-numbers
expect_scene "  between commas" 2 1 commas_quoted.csv --distance 0.75 --comma-numbers --separator ,
expect_error "a comma that is not expected" "comma_and_point.csv:2: x: '0,5' has a comma in the place of the decimal point; --comma-numbers takes it" \
             comma_and_point.csv --distance 1
expect_error "a point that is not expected" "comma_and_point.csv:2: y: '1.5' has a point, and --comma-numbers is for commas" \
             comma_and_point.csv --distance 1 --comma-numbers
expect_error "commas in no table" "--comma-numbers needs a table" points.xyz --distance 1 --comma-numbers

printf 'id,x,y\nA,0,0\nB,,1\nC,1,0\nD,NA,1\nE,1,nan\nF,1,0.5\n' > gaps.csv
expect_error "an empty cell" "gaps.csv:3: x is empty; --skip-missing leaves such rows out" gaps.csv --distance 1
expect_error "N/A" "gaps_na.csv:2: x: 'N/A' is no finite number; --skip-missing leaves such rows out" \
             gaps_na.csv --distance 1
expect_scene "rows without coordinates are skipped" 3 2 gaps.csv --distance 1 --skip-missing --pairs pairs.csv \
             --points points.csv
verdict "  and counted" test "$(summary skipped)" = "3 rows"
printf '%s\n' 0,2,A,C,1 2,5,C,F,0.5 i,j,id_i,id_j,distance > expected
sort pairs.csv > sorted
verdict "  positions are those of rows" cmp -s sorted expected
verdict "  of the points as well" test "$(tail -n 1 points.csv)" = "5,F,1,0"
expect_scene "  of two files" "3 and 2" 4 gaps.csv thirds_gap.csv --distance 1 --skip-missing --pairs pairs.csv
verdict "  which are counted apart" test "$(summary skipped)" = "3 and 1 rows"
verdict "  with the rows of both" grep -qx '5,2,F,,0.5' pairs.csv
expect_closest "  and the closest pair" "2 5, C and F" 0.25 gaps.csv --skip-missing
expect_scene "  beside a file that is no table" "3 and 3" 3 gaps.csv points.xyz --distance 0.5 --skip-missing --dimension 2
expect_error "a word is not skipped" "word.csv:3: y: 'oops'" word.csv --distance 1 --skip-missing
expect_error "infinity is not skipped" "infinite.csv:3: y: '-inf'" infinite.csv --distance 1 --skip-missing

printf 'name,e,n\nP,0,0.5\n' > other_names.csv
expect_scene "columns of each file" "3 and 1" 3 gaps.csv other_names.csv --skip-missing --distance 1.2 --columns x,y \
             --columns e,n --id id --id name --pairs pairs.csv
verdict "  and its ids" grep -q ',F,P,1$' pairs.csv
expect_scene "  or the usual ones of one" "3 and 1" 3 gaps.csv other_names.csv --skip-missing --distance 1.2 \
             --columns '' --columns 2,3
expect_scene "  beside no table" "3 and 3" 2 other_names3.csv points.xyz --distance 0.55 --columns e,n,h --id name
expect_error "more columns than files" "--columns is given once, or once for each file" ties.csv --distance 1 \
             --columns x,y --columns x,y
expect_error "more ids than files" "--id is given once, or once for each file" ties.csv --distance 1 --id x --id y

for columns in lat,lon lon,lat 1,2 2,1; do
  expect_pairs "degrees in the order $columns" 1 lon_last.csv --geographic --distance 1112m --columns $columns
done
expect_pairs "x is a longitude" 1 x_and_y.csv --geographic --distance 600m --columns x,y
expect_pairs "  in any order" 1 x_and_y.csv --geographic --distance 600m --columns y,x
expect_error "degrees without names" "by number from 1, the latitude first" bare.csv --geographic --distance 1

printf 'L\344nge,Breite\n0,0\n1,0\n' > latin.csv
expect_scene "column names in Latin-1" 2 1 latin.csv --distance 1 --columns Länge,breite
expect_scene "  asked for in Latin-1" 2 1 latin.csv --distance 1 --columns $'L\344nge,Breite'
expect_error "  are listed in UTF-8" "no column 'z' among Länge, Breite" latin.csv --distance 1 --columns z,breite
printf 'x,y,x\n0,0,5\n1,0,5\n' > twins.csv
printf 'x,y,X\n0,0,5\n1,0,5\n' > near_twins.csv
printf 'id,x,y,id\n0,0,0,5\n1,1,0,5\n' > twin_ids.csv
expect_error "two columns of one name" "twins.csv:1: columns 1 and 3 are both named x; choose one by its number" twins.csv --distance 1 --columns x,y
expect_error "  also of ids" "twin_ids.csv:1: columns 1 and 4 are both named id" twin_ids.csv --distance 1
expect_scene "  are known by number" 2 1 twins.csv --distance 1 --columns 1,2
expect_scene "  or by case" 2 1 near_twins.csv --distance 1 --columns x,y
expect_error "a column twice" "ties.csv:1: --columns takes column 1 twice" ties.csv --distance 1 --columns x,x

{ echo x,y; yes 1234567,7654321 | head -n 150000; } > long_table.csv
run long_table.csv long_table.csv --closest --progress
verdict "--progress tells of reading" grep -qE 'reading +[1-9][0-9] %' err
run - --closest --progress < long_table.csv
verdict "  from a pipe as well" grep -qE 'reading +2 MiB' err
run long_table.csv --closest
verdict "  if it is asked for" test ! -s err

# ---------------------------------------------------------------- units and hints

printf 'lat,lon\n0,0\n0,0.01\n0,1\n' > equator.csv
for distance in 1200m 1.2km '1.2 km' 0.65nmi 0.7mi 3937.1ft 6/5km 1200; do
  expect_pairs "a distance of $distance" 1 equator.csv --geographic --distance "$distance"
done
run equator.csv --geographic --distance 1.2km
verdict "  is printed with its unit" test "$(summary distance)" = "$(printf '\xe2\x89\xa4') 1.2 km"
sed 's/lon/Lng/' equator.csv > lng.csv
expect_pairs "a longitude of another name" 1 lng.csv --geographic --distance 1.2km
for distance in 1111m 1.111km 0.6nmi 0.69mi 3648ft; do
  expect_pairs "a distance of $distance" 0 equator.csv --geographic --distance "$distance"
done
expect_error "a unit on the plane" "'5 m' has a unit, which is for --geographic" ties.csv --distance "5 m"
expect_error "an unknown unit" "the unit is none of m, km, nmi, mi and ft" equator.csv --geographic --distance 5cm
expect_error "a unit of an area" "'5m' is no number" equator.csv --geographic --squared-distance 5m
expect_error "less than no meters" "is negative" equator.csv --geographic --distance -1km

has_hints() { # COUNT
  [ "$status" -eq 0 ] && [ "$(grep -c '^near_pairs: hint: ' err)" -eq "$1" ] &&
    [ "$(wc -l < err)" -eq "$1" ]
}
run equator.csv --distance 1
verdict "degrees in the plane make a hint" has_hints 1
verdict "  to measure meters" grep -q -- '--geographic' err
run equator.csv --distance 1 --decimal
verdict "  unless they are meant" has_hints 0
run equator.csv --distance 1 --geographic
verdict "  or on the sphere" has_hints 0
run equator.csv --geographic --distance 2000km
verdict "an arc of 2000 km makes a hint" has_hints 1
verdict "  to its chord" grep -q '2000000 m along its surface are 1991798 m$' err
for distance in 900km 0; do
  run equator.csv --geographic --distance $distance
  verdict "  $distance does not" has_hints 0
done
run ties.csv --distance 0.1
verdict "ties that rounding takes apart make a hint" has_hints 1
verdict "  to take decimals" grep -q -- '--decimal' err
run ties.csv --squared-distance 0.01 --open
verdict "  also if they are open" has_hints 1
run ties.csv --distance 0.1 --decimal
verdict "  unless decimals are taken" has_hints 0
for distance in 0.15 1e400; do
  run ties.csv --distance $distance
  verdict "  or there are no ties, as at $distance" has_hints 0
done
printf 'x,y\n0.5,0\n1,0\n1.5,0\n' > halves.csv
run halves.csv --distance 0.5
verdict "  or doubles see all of them" has_hints 0

# ---------------------------------------------------------------- the closest pair

expect_closest "a pair of four" "1 2" 2 thirteen.csv
expect_closest "the first of 99 ties" "0 1" 0.01 ties.csv --decimal
expect_closest "equal points" "0 1" 0 equal.csv
expect_closest "with ids" "0 1, a, b and c" 1 quoted.csv
expect_closest "by columns" "0 1, a, b and c" 1 quoted.csv --columns x,y
expect_closest "in space" "0 1" 0.25 points.xyz
expect_closest "two files" "1 2, c and " 0 named.csv plane.txt --decimal
expect_closest "  of doubles" "1 2, c and " 0 named.csv plane.txt
printf 'x,y\n5,5\n-3,0\n' > ends.csv
expect_closest "  the first of ties" "0 1" 9 <(printf 'x,y\n0,0\n8,5\n') ends.csv --format csv
{ echo x,y; yes 1,2 | head -n 20000; } > same.csv
printf 'x,y\n0,0\n1,2\n' > end.csv
expect_closest "  of very many" "1 0" 0 end.csv same.csv
expect_closest "  of very many on both sides" "0 0" 0 same.csv same.csv
{ echo x,y; seq -f '0.%05g,0' 0 9999; } > near_zero.csv
{ echo x,y; seq -f '7.%05g,0' 10000 19999; } > near_seven.csv
expect_closest "  of all at nearly one distance" "9999 0" 49.0001400001 near_zero.csv near_seven.csv \
               --decimal
for kernel in epick exact; do
  expect_closest "  of ships, $kernel" "4961 3842, 4961 and 8842" 0.0000000005 first_ships.csv \
                 other_ships.csv --decimal --kernel $kernel
done
run first_ships.csv other_ships.csv --decimal --squared-distance 0.0000000005 --pairs pairs.csv
verdict "  is the first at this distance" test "$(summary 'on boundary') $(tail -n +2 pairs.csv | sort -n | head -n 1)" \
        = "$(summary pairs) 4961,3842,4961,8842,2.236067977e-05"
expect_error "the closest pair with no points" "--closest needs a point in each file" equal.csv empty.csv --closest
run quoted.csv --closest --pairs pairs.csv --picture picture.svg
printf 'i,j,id_i,id_j,distance\n0,1,"a, b",c,1\n' > expected
verdict "the closest pair as a table" cmp -s pairs.csv expected
verdict "  and as a picture" grep -q '^</svg>' picture.svg

# ---------------------------------------------------------------- outputs

run quoted.csv --distance 1 --pairs pairs.csv --picture picture.svg
printf 'i,j,id_i,id_j,distance\n0,1,"a, b",c,1\n' > expected
verdict "pairs with ids" cmp -s pairs.csv expected
run thirteen.csv --squared-distance 13 --open --pairs -
printf 'i,j,distance\n1,2,1.414213562\n' > expected
verdict "pairs on stdout" cmp -s out expected
verdict "  with the summary on stderr" grep -q '^pairs  *1$' err
verdict "the picture is an SVG file" grep -q '^</svg>' picture.svg
if command -v python3 > /dev/null; then
  verdict "  and well-formed" python3 -c 'import xml.dom.minidom as m; m.parse("picture.svg")'
fi
"$binary" thirteen.csv --squared-distance 13 --open --pairs /dev/stdout 2> err | cat > out
verdict "  by its other name" cmp -s out expected
verdict "  with the summary on stderr" grep -q '^pairs  *1$' err
"$binary" ties.csv --distance 1 --pairs summary.csv > summary.csv 2> err
status=$?
true > out
verdict "pairs in the file of the summary" is_one_error "summary.csv: is the standard output"
run ties.csv --distance 1 --picture -
verdict "the picture on stdout" test "$(tail -n 1 out)" = "</svg>"
verdict "  with the summary on stderr" grep -q '^pairs  *' err
for name in x.png x.pdf x.svg.gz; do
  run ties.csv --distance 1 --picture $name
  verdict "no picture $name" is_one_error "the picture is an SVG file, so name it .svg"
  verdict "  and no file" test ! -e $name
done

# Each text of a picture must be inside of it. Letters are about as wide as in DejaVu Sans.
if command -v python3 > /dev/null; then
  cat > inside.py << 'END'
import re, sys, xml.dom.minidom
svg = xml.dom.minidom.parse(sys.argv[1]).documentElement
width, height = float(svg.getAttribute("width")), float(svg.getAttribute("height"))
for text in svg.getElementsByTagName("text"):
    size = float(text.getAttribute("font-size") or 13)
    words = "".join(node.data for node in text.childNodes)
    long, (x, y) = 0.58 * size * len(words), (float(text.getAttribute(a)) for a in "xy")
    left = x - {"": 0, "middle": 0.5, "end": 1}[text.getAttribute("text-anchor")] * long
    box = (left, y - 0.8 * size, left + long, y + 0.3 * size)
    turned = re.match(r"translate\((\S+) (\S+)\) rotate", text.parentNode.getAttribute("transform"))
    if turned:
        x, y = float(turned[1]), float(turned[2])
        box = (x + box[1], y - box[2], x + box[3], y - box[0])
    if box[0] < 0 or box[1] < 0 or box[2] > width or box[3] > height:
        print("outside:", words, box, width, height, file=sys.stderr)
        sys.exit(1)
END
  # Runs the program, with the picture of a scene, and looks for texts that are cut off.
  expect_inside() { # NAME ARGUMENT...
    local name=$1
    shift
    run "$@" --picture picture.svg
    is_inside() { [ "$status" -eq 0 ] && python3 inside.py picture.svg 2> err; }
    verdict "all texts are inside the picture: $name" is_inside
  }
  { echo x,y; seq -f '%g,0' 0 209; } > line.csv
  { echo x,y; seq -f '0.%03g,0' 0 299; echo 9999,9999; } > cluster.csv
  long_name=$(head -c 200 /dev/zero | tr '\0' W).csv
  printf 'x_of_a_long_name_that_says_it_all,<y>\001_of_a_long_name_that_says_it_all\n%s\n' \
         $'5,-1234567891234567\n7,-1234567891234569' > "$long_name"
  printf 'x,y\n0,0\n0,-1.23456789e-300\n' > $'\377.csv'
  expect_inside "a line" line.csv --distance 1000
  verdict "  which tells that lines are left out" grep -q 'only 20000 lines are drawn' picture.svg
  expect_inside "a cluster" cluster.csv --distance 1
  verdict "  which tells that lines are left out" grep -q 'only 20000 lines are drawn' picture.svg
  expect_inside "ships" "$ships" --geographic --distance 500
  expect_inside "long names" "$long_name" --columns 1,2 --distance 1
  expect_inside "a long distance" ties.csv --distance "0.$(head -c 500 /dev/zero | tr '\0' 1)"
  expect_inside "a name in other bytes" $'\377.csv' --distance 1
fi
for scene in empty single equal; do
  run $scene.csv --distance 0 --picture picture.svg
  has_no_nan() { [ "$status" -eq 0 ] && ! grep -qE 'nan|inf[^o]' picture.svg; }
  verdict "picture of the scene $scene" has_no_nan
done
run ties.csv --distance 1 --explain
verdict "--explain describes the scene" grep -q 'reach' out
verdict "--explain tells what decided" grep -q 'no filter used\|decide the rest' out
verdict "--explain has the dimension of the plane" grep -q 'in dimension 2$' out
has_two_axes() { [ "$(grep -c '^axis' out)" -eq 2 ]; }
verdict "  and its axes" has_two_axes
run ties.csv --distance 1 --progress
verdict "--progress shows a percentage" grep -q '100 %' err
run --help
verdict "--help" test "$status" -eq 0 -a -s out -a ! -s err
run --version
verdict "--version" test "$status" -eq 0 -a ! -s err
verdict "  is that of the package" grep -qE "^near_pairs $version, with CGAL [0-9.]+" out
verdict "no temporary file is left" test -z "$(find . -name '*part*')"

# ---------------------------------------------------------------- points, components and maps

printf 'id,x,y\n"a, b",0,0\nc,0.5,0\nd,9,9\ne,1,0\nf,9,8.5\ng,-4,0.1\n' > groups.csv
run groups.csv --distance 0.5 --points points.csv --pairs pairs.csv --coordinates --components
printf '%s\n' i,id,x,y,neighbors,component '0,"a, b",0,0,1,0' 1,c,0.5,0,2,0 2,d,9,9,1,1 3,e,1,0,1,0 \
       4,f,9,8.5,1,1 5,g,-4,0.1,0,2 > expected
verdict "points with neighbors and components" cmp -s points.csv expected
verdict "  are counted" test "$(summary components)" = "3, the largest of 3 points"
printf '%s\n' '0,1,"a, b",c,0,0,0.5,0,0.5' 1,3,c,e,0.5,0,1,0,0.5 2,4,d,f,9,9,9,8.5,0.5 \
       i,j,id_i,id_j,x_i,y_i,x_j,y_j,distance > expected
sort pairs.csv > sorted
verdict "pairs with coordinates" cmp -s sorted expected
run groups.csv --distance 0.5 --points points.csv
printf '%s\n' i,id,neighbors,component '0,"a, b",1,0' > expected
verdict "points without coordinates" test "$(head -n 2 points.csv)" = "$(cat expected)"
run groups.csv groups.csv --distance 0 --points points.csv
verdict "points of two files" test "$(sed -n 8p points.csv)" = '0,2,"a, b",1,0'
run groups.csv --closest --points points.csv
verdict "points of the closest pair" test "$(sed -n 3p points.csv)" = "1,c,1,0"
run empty.csv --distance 1 --points - --components
verdict "no points" test "$status $(cat out)" = "0 i,neighbors,component"
verdict "  with the summary on stderr" grep -q '^components   0, the largest of 0 points$' err
expect_error "two outputs of one name" "two outputs have the name none.csv" ties.csv --distance 1 --points none.csv
ln -s . here
for name in ./none.csv here/none.csv; do
  expect_error "two names of one output" "two outputs have the name" ties.csv --distance 1 --points $name
done
for name in none.csv.gz none.json none.TSV none.txt; do
  expect_error "a table $name" "so name it .csv or .geojson" ties.csv --distance 1 --points $name
done
expect_error "a map of the plane" "a map has latitudes and longitudes" ties.csv --distance 1 --points none.geojson
run ties.csv --distance 1 --coordinates
verdict "coordinates without a table" is_one_error "--coordinates is for --pairs and --points"

# The same from the definition, by another program.
if command -v python3 > /dev/null; then
  cat > components.py << 'END'
import csv, sys
pairs, points = (list(csv.DictReader(open(name))) for name in sys.argv[1:])
group, neighbors = list(range(len(points))), [0] * len(points)
def root(i):
    while group[i] != i:
        group[i] = i = group[group[i]]
    return i
for pair in pairs:
    i, j = int(pair["i"]), int(pair["j"])
    group[root(i)] = root(j)
    neighbors[i] += 1
    neighbors[j] += 1
numbers = {}
for i, point in enumerate(points):
    number = numbers.setdefault(root(i), len(numbers))
    if (int(point["neighbors"]), int(point["component"])) != (neighbors[i], number):
        sys.exit("point %d: %s" % (i, point))
END
  run "$ships" --geographic --distance 500m --pairs pairs.csv --points points.csv --components \
      --coordinates --picture picture.svg
  verdict "components of ships" python3 components.py pairs.csv points.csv
  verdict "  with the coordinates of the file" \
          test "$(awk -F, '{ print $2, $3 + 0, $4 + 0 }' points.csv)" \
               = "$(awk -F, '{ print $1, $3 + 0, $4 + 0 }' "$ships")"
  is_inside_picture() { python3 inside.py picture.svg 2> err; }
  verdict "  colored in the picture" is_inside_picture
  printf 'id,lat,lon\n"\\""\001\377",10,179\nb,20,-179\nc,-5.25,-0.000001\n' > meridian.csv
  run meridian.csv --geographic --distance 2000km --pairs pairs.geojson --points points.geojson
  cat > map.py << 'END'
import json
pairs, points = (json.load(open(name + ".geojson"))["features"] for name in ("pairs", "points"))
assert [pair["geometry"] for pair in pairs] == [
    {"type": "MultiLineString", "coordinates": [[[179, 10], [180, 15]], [[-180, 15], [-179, 20]]]}]
assert pairs[0]["properties"]["id_i"] == '\\"??', pairs
assert points[2]["geometry"] == {"type": "Point", "coordinates": [-0.000001, -5.25]}
assert points[2]["properties"] == {"i": 2, "id": "c", "neighbors": 0, "component": 1}
END
  verdict "maps in GeoJSON" python3 map.py
  # Half a letter of UTF-16, two forms that are too long, and a number beyond all letters.
  printf 'id,lat,lon\n\355\240\200,10,179\n\340\200\257,20,-179\n\300\257,30,0\n\364\220\200\200,40,0\n' \
    > letters.csv
  run letters.csv --geographic --distance 2000km --pairs pairs.geojson --points points.geojson
  verdict "  are UTF-8" python3 -c 'open("points.geojson", "rb").read().decode("utf-8")'
  run equator.csv --distance 1 --pairs pairs.geojson --points points.geojson --decimal
  verdict "  of degrees in the plane" grep -q '"coordinates":\[\[0.01,0\],\[1,0\]\]' pairs.geojson
  run equator.csv --distance 0 --geographic --pairs pairs.geojson
  verdict "  without pairs" python3 -c 'import json; assert json.load(open("pairs.geojson"))["features"] == []'
fi
run --help
fits_a_screen() { [ "$(wc -l < out)" -le 48 ] && ! grep -qE '^.{81}' out; }
verdict "the help has one screen" fits_a_screen

# ---------------------------------------------------------------- features

cat > shapes.wkt << 'END'
# a square with a hole, a point in the hole, one in the square, and a line that ends on an edge
POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))
POINT Z (2 2 7)

SRID=4326;POINT(0.5 0.5)
LineString (4 2, 9 2, 9 9)
MULTIPOINT((2.5 2), 20 20)
GEOMETRYCOLLECTION(POINT(30 30), MULTILINESTRING((40 40, 41 41)), MULTIPOLYGON(((8 8,10 8,10 10,8 8))))
POINT EMPTY
END
cat > shapes.geojson << 'END'
{"type": "FeatureCollection", "features": [
{"type": "Feature", "id": "b,c", "properties": {"name": "tower", "height": 12.5},
 "geometry": {"type": "Point", "coordinates": [0.5, 0.5, 99]}},
{"type": "Feature", "id": 7, "properties": null, "geometry": null},
{"type": "Feature", "properties": {"id": "x", "name": "wall"},
 "geometry": {"type": "GeometryCollection", "geometries": [
  {"type": "MultiPolygon", "coordinates": [[[[7, 1], [8, 1], [8, 3], [7, 1]]]]},
  {"type": "LineString", "coordinates": [[30, 30], [31, 31]]}]}}]}
END
printf 'id,x,y\nP,9,5\nQ,2,2\n' > shape_points.csv

# The program must end well, with these features and this list of pairs.
expect_features() { # NAME FEATURES PAIRS ARGUMENT...
  local name=$1 features=$2 pairs=$3
  shift 3
  run "$@" --pairs features.csv
  verdict "$name: $features features, pairs $pairs" \
          test "$status $(summary features) $(echo $(sorted_pairs features.csv))" = "0 $features $pairs"
}
expect_features "features that meet" 7 "0,2 0,3 3,5" shapes.wkt --distance 0
expect_features "  strictly closer than a half" 7 "0,2 0,3 3,5" shapes.wkt --distance 1/2 --open
expect_features "  at most a half" 7 "0,2 0,3 0,4 1,4 3,5" shapes.wkt --distance 1/2
expect_features "  by the square" 7 "0,2 0,3 0,4 1,4 3,5" shapes.wkt --squared-distance 1/4
expect_features "features of two files" "7 and 3" "0,0 2,0 3,2 5,2" shapes.wkt shapes.geojson --distance 0
run shapes.geojson shapes.wkt --distance 0 --pairs features.csv
verdict "  with ids and properties" grep -qxF \
        '0,2,"b,c",,"{""height"":12.5,""name"":""tower""}",' features.csv
run shapes.geojson shapes.wkt --distance 0 --pairs features.csv --id name
verdict "  named by a property" grep -q '^2,3,wall,,' features.csv
expect_features "points and features" "2 and 7" "0,3 1,1" shape_points.csv shapes.wkt --distance 0
verdict "  with the ids of points" grep -qx '0,3,P,' features.csv
verdict "  that are counted" test "$(summary 'in pairs')" = "2 and 2 of the features"
expect_features "a geometry alone" 1 "" --distance 0 - --format geojson \
                <<< '{"type":"Point","coordinates":[1,2]}'
run shapes.wkt --distance 1/2 --picture features.svg
verdict "the picture of features" grep -q '^</svg>' features.svg
if command -v python3 > /dev/null; then
  is_inside_features() { python3 inside.py features.svg 2> err; }
  verdict "  has its texts inside" is_inside_features
fi

expect_wkt_error() { # MESSAGE TEXT
  printf '\n%s\n' "$2" > wrong.wkt
  expect_error "WKT ${2:0:40}" "wrong.wkt:2:$1" wrong.wkt --distance 1
}
expect_wkt_error "1: 'CIRCLE' is no kind of geometry" "CIRCLE(0 0)"
expect_wkt_error "9: 'nan' is no finite number" "POINT(0 nan)"
expect_wkt_error "8: ')' is no finite number" "POINT(0)"
expect_wkt_error "10: ')' is missing" "POINT(0 0"
expect_wkt_error "12: 'x' is behind the geometry" "POINT(0 0) x"
expect_wkt_error "15: a line has fewer than two" "LINESTRING(0 0)"
expect_wkt_error "22: a ring has fewer than four" "POLYGON((0 0,1 1,0 0))"
expect_wkt_error "26: a ring does not end where it begins" "POLYGON((0 0,1 0,1 1,0 1))"
expect_wkt_error "400: collections are nested too deep" \
                 "$(yes 'GEOMETRYCOLLECTION(' | head -n 100000 | tr -d '\n')"
expect_json_error() { # MESSAGE TEXT
  printf '%s' "$2" > wrong.geojson
  expect_error "GeoJSON ${2:0:40}" "wrong.geojson:$1" wrong.geojson --distance 1
}
expect_json_error "1:2: syntax error" "{"
expect_json_error " the text is no object" "[]"
expect_json_error ' /type "Circle" is no kind' '{"type":"Circle","coordinates":[0,0]}'
expect_json_error ' /coordinates is no list of two' '{"type":"Point","coordinates":[0]}'
expect_json_error ' /coordinates is wrong: a ring does not end' \
                  '{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1]]]}'
expect_json_error "1:1051: brackets are nested too deep" \
  "{\"type\":\"Feature\",\"geometry\":null,\"properties\":{\"a\":$(yes '[' | head -n 300000 | tr -d '\n')"
expect_json_error " number overflow" '{"type":"Point","coordinates":[1e999,0]}'
for option in "--closest" "--distance 1 --decimal" "--distance 1 --geographic" \
              "--distance 1 --components" "--distance 1 --kernel exact" \
              "--distance 1 --points points.csv"; do
  run shapes.wkt $option
  verdict "no $option of features" is_one_error \
          "is for points, and a file of WKT or GeoJSON has features"
done
expect_error "features in space" "features are in the plane" points.xyz shapes.wkt --distance 1

# The same by GEOS, on random features with corners in a lattice: many of them touch. No two of them
# are at a distance of exactly 0.7.
geos=$(for python in python3 /usr/bin/python3; do
         "$python" -c 'import shapely' 2> /dev/null && echo "$python"; done | head -n 1)
if [ -n "$geos" ]; then
  cat > geos.py << 'END'
import json, random, sys
from shapely.geometry import mapping, box, GeometryCollection, LineString, MultiPoint, MultiPolygon, Point, Polygon
random.seed(7)
def at(): return random.randrange(60), random.randrange(60)
def near(p, most=6): return p[0] + random.randint(-most, most), p[1] + random.randint(-most, most)
def shape():
    p, kind = at(), random.randrange(7)
    if kind == 0: return Point(p)
    if kind == 1: return MultiPoint([p, near(p)])
    if kind == 2: return LineString([p, near(p), near(p)])
    if kind == 3: return Polygon([p, (p[0] + random.randint(1, 6), p[1]), (near(p)[0], p[1] + 5)])
    square = box(*p, p[0] + 8, p[1] + 8)
    if kind == 4: return Polygon(square.exterior, [box(p[0] + 1, p[1] + 1, p[0] + 6, p[1] + 7).exterior])
    if kind == 5: return MultiPolygon([square, box(p[0] + 8, p[1] + 9, p[0] + 11, p[1] + 10)])
    return GeometryCollection([Point(p), LineString([near(p), near(p)]), Polygon([p, (p[0] + 1, p[1]), p])])
shapes = [[s for s in (shape() for _ in range(150)) if s.is_valid] for _ in range(2)]
for name, part in zip("ab", shapes):
    open(name + ".wkt", "w").write("".join(s.wkt + "\n" for s in part))
    json.dump({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": mapping(s)} for s in part]}, open(name + ".geojson", "w"))
def meet(a, b, r): return a.intersects(b) if r == 0 else a.distance(b) <= r
for name, r in ("meet", 0), ("near", 0.7):
    a, b = shapes
    own = [(i, j) for j in range(len(a)) for i in range(j) if meet(a[i], a[j], r)]
    two = [(i, j) for i in range(len(a)) for j in range(len(b)) if meet(a[i], b[j], r)]
    for file, pairs in ("own", own), ("two", two):
        open(file + "_" + name, "w").write("i,j\n" + "".join("%d,%d\n" % pair for pair in pairs))
END
  "$geos" geos.py
  for scene in "meet 0" "near 0.7"; do
    read -r name distance <<< "$scene"
    for format in wkt geojson; do
      run a.$format --distance $distance --pairs features.csv
      verdict "random features, .$format, $name: $(($(wc -l < own_$name) - 1)) pairs, as by GEOS" \
              same_pairs features.csv own_$name
      run a.wkt b.$format --distance $distance --pairs features.csv
      verdict "  of two files: $(($(wc -l < two_$name) - 1)) pairs" \
              same_pairs features.csv two_$name
    done
  done
  run a.wkt b.wkt --distance 0.7 --parallel --pairs features.csv
  grep -q "built without TBB" err || verdict "  in parallel" same_pairs features.csv two_near

  cat > shore.py << 'END'
import csv, json, sys
from shapely.geometry import Point, shape
ships = [(float(row["lon_deg"]), float(row["lat_deg"])) for row in csv.DictReader(open(sys.argv[1]))]
print("i,j")
for j, feature in enumerate(json.load(open(sys.argv[2]))["features"]):
    shore = shape(feature["geometry"])
    x, y, right, top = shore.bounds
    for i, (e, n) in enumerate(ships):
        if x - 1 < e < right + 1 and y - 1 < n < top + 1 and shore.distance(Point(e, n)) <= 0.002:
            print("%d,%d" % (i, j))
END
  "$geos" shore.py "$ships" "$data/puget_sound.geojson" > shore
fi
run "$ships" "$data/puget_sound.geojson" --distance 0.002 --pairs features.csv
verdict "ships by the shore of Puget Sound: 849 pairs" \
        test "$status $(summary pairs) $(summary 'in pairs')" = "0 849 848 and 20 of the features"
[ -z "$geos" ] || verdict "  as by GEOS" same_pairs features.csv shore

# ---------------------------------------------------------------- scenes that repeat

cat > salt.xyz << 'END'
8
Lattice="5.64 0 0 0 5.64 0 0 0 5.64" Properties=species:S:1:pos:R:3 energy=-27.5
Na 0 0 0
Cl 0 0 2.82
Cl 0 2.82 0
Na 0 2.82 2.82
Cl 2.82 0 0
Na 2.82 0 2.82
Na 2.82 2.82 0
Cl 2.82 2.82 2.82
END
tail -n 8 salt.xyz | cut -d ' ' -f 2- > salt.txt
{ cat salt.xyz; printf '1\n\nNe 9 9 9\n'; } > frames.xyz
printf '2\n\nO 0 0 0.5 -1 -1\n8 0 0 1\n' > atoms.xyz
head -n 9 salt.xyz > cut.xyz
sed 's/Na 0 0 0/Na 0 0/' salt.xyz > short_atom.xyz
cat > slab.xyz << 'END'
4
config="a slab=b" pbc="T F T" Properties=id:I:1:force:R:3:pos:R:3:species:S:1 Lattice="1.5 0 0.5 0 0 0 0.5 0 2"
7 9 9 9 0 0 0 C
8 9 9 9 0.25 1 1 Si
9 9 9 9 1.75 0.5 4 C
5 9 9 9 0.25 0.5 3.25 C
END
awk 'NR > 2 { print $5, $6, $7 }' slab.xyz > slab.txt
printf 'x,y\n0.5,0\n9.5,0\n-19.5,21\n' > wide.csv
awk 'BEGIN { srand(3); print "x,y"
             for(i = 0; i < 24; ++i) printf "%.1f,%.1f\n", 2 * rand() - 0.6, 2 * rand() - 0.9 }' > tenths.csv
awk 'BEGIN { srand(4); for(i = 0; i < 14; ++i) printf "%d %d %d\n", 9 * rand(), 9 * rand(), 9 * rand() }' \
    > integers.txt
printf '%s\n' 'CRYST1   10.000   20.100   30.200  90.00  90.00  90.00 P 1           1' \
       'ATOM      1  N   THR A   1       0.100   0.200   0.000  1.00 13.79           N' \
       'ATOM      2  C   THR A   1       0.100  20.000  29.900  1.00 13.79           C' > box.pdb
sed '1s/90.00  90.00  90.00 P 1    /80.00 100.00 115.00 P 21 21 21/' box.pdb > skew.pdb
sed '1s/.*/CRYST1    1.000    1.000    1.000  90.00  90.00  90.00 P 1           1/' box.pdb > unit.pdb

expect_scene "atoms of .xyz" 2 1 atoms.xyz --distance 0.5
run atoms.xyz --closest
verdict "  are named by their elements" test "$(summary 'closest pair')" = "0 1, O and 8"
expect_scene "  of the first frame" 8 12 frames.xyz --distance 2.82 --decimal
expect_scene "  as the comment tells" 4 0 slab.xyz --distance 1
expect_error "fewer atoms than there should be" "cut.xyz:9: the file ends after 7 atoms of 8" cut.xyz --distance 1
expect_error "an atom without a place" "short_atom.xyz:3: 3 words where 4 are needed" short_atom.xyz --distance 1
for properties in pos:R:x pos:R:2 species:S:1; do
  sed "2s/.*/Properties=$properties/" salt.xyz > wrong.xyz
  expect_error "atoms with $properties" "wrong.xyz:2: Properties: " wrong.xyz --distance 1
done

expect_crossing() { # PAIRS
  verdict "  $1 of them cross the boundary" test "$(summary crossing)" = "$1, the boundary of the cell"
}

expect_pairs "rock salt" 24 salt.xyz --periodic file --distance 2.82 --decimal --pairs pairs.csv --points points.csv
expect_boundary 24
expect_crossing 12
verdict "  its cell" test "$(summary cell)" = "5.64, 5.64, 5.64"
verdict "  six neighbors of each atom" test "$(tail -n +2 points.csv | cut -d, -f 3 | sort | uniq -c | xargs)" = "8 6"
verdict "  and their names" test "$(grep '^0,1,' pairs.csv | sort | xargs)" \
        = "0,1,0,0,-1,Na,Cl,2.82 0,1,0,0,0,Na,Cl,2.82"
expect_pairs "  strictly closer" 0 salt.xyz --periodic file --distance 2.82 --decimal --open
expect_crossing 0
expect_pairs "  by the sides" 24 salt.txt --periodic 5.64,5.64,141/25 --distance 2.82 --decimal
expect_pairs "  without a boundary" 12 salt.txt --distance 2.82 --decimal
verdict "  which has no cell" test "$(summary cell)$(summary crossing)" = ""
run salt.txt --periodic 5.64,5.64,5.64 --distance 2.82
verdict "  as doubles makes a hint" has_hints 1
verdict "  to take decimals" grep -q -- '--decimal' err
expect_pairs "sides, and points outside" 2 wide.csv --periodic 10,20 --distance 1
expect_crossing 2
printf '%s\n' 0,1,-1,0,0.5,0,9.5,0,1 0,2,2,-1,0.5,0,-19.5,21,1 1,2,3,-1,9.5,0,-19.5,21,1.414213562 > expected
expect_pairs "  a little longer" 3 wide.csv --periodic 10,20 --squared-distance 2 --pairs pairs.csv --coordinates
verdict "  with offsets" test "$(tail -n +2 pairs.csv | sort)" = "$(cat expected)"
verdict "  behind the positions" grep -qx i,j,offset_1,offset_2,x_i,y_i,x_j,y_j,distance pairs.csv
expect_closest "  the closest pair" "0 1" 1 wide.csv --periodic 10,20
verdict "  its offset" test "$(summary offset)" = "-1 0"
expect_closest "a point and its image" "0 0" 4 single.csv --periodic 3,2
verdict "  their offset" test "$(summary offset)" = "0 1"
expect_closest "a bond of rock salt" "0 1, Na and Cl" 7.9524 salt.xyz --periodic file --decimal
verdict "  the first of ties" test "$(summary offset)" = "0 0 -1"
run salt.xyz --periodic file --closest --decimal --parallel
grep -q "built without TBB" err || verdict "  in parallel" test "$(summary offset)" = "0 0 -1"
expect_pairs "right angles of a crystal" 3 box.pdb --periodic file --squared-distance 100 --decimal
expect_boundary 2
verdict "  make an exact cell" test "$(summary cell)" = "10, 20.1, 30.2"
verdict "  without a hint" test ! -s err
run box.pdb --periodic file --squared-distance 0.18 --decimal --pairs pairs.csv
verdict "  of the second atom" grep -q '^0,1,0,-1,-1,1,2,0.42426' pairs.csv
run skew.pdb --periodic file --distance 10.5 --decimal
verdict "other angles are rounded" grep -qE '^cell         10, \(-8\.4[0-9]* 18\.2[0-9]* 0\), .*, rounded$' out
verdict "  and a space group makes a hint" has_hints 1
verdict "  to its copies" grep -q 'P 21 21 21 are not in the file' err

# The same from the definition: an image of a point for each offset, in rational numbers.
if command -v python3 > /dev/null; then
  cat > images.py << 'END'
# images.py VECTORS REPEATS SQUARED decimal|double FILE [FILE]: prints the pairs, and then how many of
# them there are, cross the boundary, and are at the distance.
import itertools, re, sys
from fractions import Fraction
vectors, repeats, squared, kind, *files = sys.argv[1:]
most = 7
number = Fraction if kind == "decimal" else lambda text: Fraction(float(text))
points = [[[number(word) for word in re.split("[, ]", line.strip())] for line in open(file) if line[0] != "x"]
          for file in files]
vectors = [Fraction(word) for word in vectors.split(",")]
dimension = len(points[0][0])
vectors = [vectors[k * dimension:(k + 1) * dimension] for k in range(dimension)]
offsets = list(itertools.product(*(range(-most, most + 1) if r == "T" else [0] for r in repeats)))
moves = {o: [sum(n * v[axis] for n, v in zip(o, vectors)) for axis in range(dimension)] for o in offsets}
found = []
for i, p in enumerate(points[0]):
    for j, q in enumerate(points[-1]):
        for o, move in moves.items():
            if len(files) == 1 and (j < i or (j == i and o <= (0,) * dimension)):
                continue
            d = sum((b + m - a) ** 2 for a, b, m in zip(p, q, move))
            if d <= Fraction(squared):
                assert max(map(abs, o)) < most
                found.append((i, j, o, d))
for i, j, o, d in found:
    print(i, j, *o, sep=",")
print(len(found), sum(any(o) for i, j, o, d in found), sum(d == Fraction(squared) for i, j, o, d in found),
      file=sys.stderr)
END

  # The program must report these pairs of images.
  expect_images() { # NAME VECTORS REPEATS SQUARED KIND "FILE..." ARGUMENT...
    local name=$1 vectors=$2 repeats=$3 squared=$4 kind=$5 files=$6
    local pairs crossing ties
    shift 6
    python3 images.py $vectors $repeats $squared $kind $files > images 2> counts
    read -r pairs crossing ties < counts
    sort images > expected
    run "$@" --squared-distance $squared --pairs pairs.csv $([ $kind = double ] || echo --decimal)
    verdict "$name: $pairs pairs of images" test "$status $(summary pairs)" = "0 $pairs"
    expect_boundary "$ties"
    expect_crossing "$crossing"
    tail -n +2 pairs.csv | cut -d, -f 1-$((2 + ${#repeats})) | sort > sorted
    verdict "  are those of the definition" cmp -s sorted expected
  }
  box="5.64,0,0,0,5.64,0,0,0,5.64"
  expect_images "rock salt" $box TTT 7.9524 decimal salt.txt salt.xyz --periodic file
  expect_images "  as doubles" $box TTT 7.9524 double salt.txt salt.xyz --periodic file
  expect_images "  within two bonds" $box TTT 31.8096 decimal salt.txt salt.txt --periodic 5.64,5.64,5.64
  expect_images "tenths" 0.7,0,0,0.5 TT 0.09 decimal tenths.csv tenths.csv --periodic 0.7,0.5
  expect_images "  as doubles" 0.7,0,0,0.5 TT 0.09 double tenths.csv tenths.csv --periodic 0.7,0.5
  expect_images "  beyond the periods" 0.7,0,0,0.5 TT 1 decimal tenths.csv tenths.csv --periodic 0.7,0.5
  expect_images "  in thirds" 1/3,0,0,2/3 TT 0.04 decimal tenths.csv tenths.csv --periodic 1/3,2/3
  expect_images "  in a skewed cell" 0.9,0,0.3,0.4 TT 0.09 decimal tenths.csv tenths.csv --periodic 0.9,0,0.3,0.4
  printf 'x,y\n0.1,0.2\n-0.5,0.9\n1.3,-0.4\n' > others.csv
  expect_images "  beside others" 0.9,0,0.3,0.4 TT 0.09 decimal "tenths.csv others.csv" tenths.csv others.csv \
                --periodic 0.9,0,0.3,0.4
  expect_images "  of a file with itself" 0.9,0,0.3,0.4 TT 0.04 decimal "tenths.csv tenths.csv" tenths.csv \
                tenths.csv --periodic 0.9,0,0.3,0.4
  expect_images "a slab" 1.5,0,0.5,0,0,0,0.5,0,2 TFT 2.5 decimal slab.txt slab.xyz --periodic file
  verdict "  named by elements" grep -qE '^[01],[123],.*,(C,Si|Si,C),' pairs.csv
  verdict "  its cell" test "$(summary cell)" = "(1.5 0 0.5), none, (0.5 0 2)"
  expect_images "integers" 9,0,1,-2,8,0,3,3,7 TTT 14 decimal integers.txt integers.txt --periodic 9,0,1,-2,8,0,3,3,7
  run integers.txt --periodic 9,0,1,-2,8,0,3,3,7 --squared-distance 14 --parallel --pairs parallel.csv
  if ! grep -q "built without TBB" err; then
    tail -n +2 parallel.csv | cut -d, -f 1-5 | sort > sorted
    verdict "  in parallel" cmp -s sorted expected
  fi
  verdict "  told with signs" test "$(summary cell)" = "(9 0 1), (-2 8 0), (3 3 7)"

  # Angles and lengths of the vectors that are printed.
  cat > angles.py << 'END'
import math, re, sys
cell = re.search("^cell +(.*), rounded$", open("out").read(), re.M)[1]
a, b, c = [float(cell.split(",")[0]), 0, 0], *[list(map(float, v.split())) for v in re.findall(r"\((.*?)\)", cell)]
def dot(v, w): return sum(x * y for x, y in zip(v, w))
def angle(v, w): return math.degrees(math.acos(dot(v, w) / math.sqrt(dot(v, v) * dot(w, w))))
wanted = [10, 20.1, 30.2, 80, 100, 115]
found = [math.sqrt(dot(v, v)) for v in (a, b, c)] + [angle(b, c), angle(a, c), angle(a, b)]
sys.exit(any(abs(x - y) > 1e-10 for x, y in zip(wanted, found)))
END
  run skew.pdb --periodic file --distance 10.5 --decimal
  verdict "the vectors of a crystal" python3 angles.py

  # A pair across the boundary is two lines, from each of its points to the middle.
  cat > halves.py << 'END'
import re
svg = open("picture.svg").read()
points = re.search(r"<path[^>]*stroke='#555555'[^>]* d='(.*?)'", svg) or re.search(r"d='(M[^']*h0[^']*)'", svg)
ends = [tuple(map(float, m)) for m in
        re.findall(r"M(\S+) (\S+)L(\S+) (\S+?)(?=M|')", re.search(r"#0072B2' d='(.*?)'/", svg)[0] + "'")]
ends.sort()
(x, y, x_end, y_end), (u, v, u_end, v_end) = ends
unit = (u - x) / 9
assert y == v == y_end == v_end
assert abs(x_end - (x - unit / 2)) < 0.2 and abs(u_end - (u + unit / 2)) < 0.2
END
  head -n 3 wide.csv > pair.csv
  expect_inside "halves of a pair" pair.csv --periodic 10,20 --distance 1
  verdict "  end in the middle" python3 halves.py
  verdict "  have their line of the legend" grep -q 'half of a pair across the boundary' picture.svg
  expect_inside "rock salt with components" salt.xyz --periodic file --distance 2.82 --decimal --components
fi

expect_error "no sides" "--periodic: 'a' is no number" ties.csv --distance 1 --periodic a,1
expect_error "one side" "--periodic: a cell has two or three sides, or vectors" ties.csv --distance 1 --periodic 1
expect_error "a side of 0" "--periodic: the sides of a cell are positive" ties.csv --distance 1 --periodic 1,0
expect_error "a box of the wrong dimension" "the cell has 3 dimensions, and points have 2 coordinates" ties.csv \
             --distance 1 --periodic 1,1,1
expect_error "vectors on a line" "The periods of the lattice are linearly dependent" ties.csv --distance 1 --periodic 1,2,2,4
expect_error "a period that is very short" "The periods are too short" ties.csv --distance 1 --periodic 1e-300,1
expect_error "a table without a cell" "ties.csv: no cell, which is Lattice in .xyz, CRYST1 in .pdb or _cell" ties.csv \
             --distance 1 --periodic file
head -c 24 /dev/zero > origin.bin
expect_error "binary points without a cell" "origin.bin: no cell" origin.bin --distance 1 --periodic file
expect_error "the cell that stands for none" "unit.pdb:1: CRYST1: the sides 1, 1, 1 stand for no cell" unit.pdb \
             --distance 1 --periodic file
sed '1s/90.00  90.00  90.00/30.00  30.00  90.00/' box.pdb > flat.pdb
sed '1s/90.00 P 1.*/90/' box.pdb > short_crystal.pdb
expect_error "angles of no cell" "flat.pdb:1: CRYST1: no cell has these angles" flat.pdb --distance 1 --periodic file
expect_error "a cell that is cut" "short_crystal.pdb:1: CRYST1: the line ends before column 54" short_crystal.pdb \
             --distance 1 --periodic file
expect_error "two cells" "box.pdb:1: the cell is not that of salt.xyz" salt.xyz box.pdb --distance 1 --periodic file
expect_scene "the cell of one of two files" "8 and 8" 56 salt.xyz salt.txt --distance 2.82 --periodic file --decimal
for wrong in 'Lattice="1 2 3 4"' 'Lattice="1 0 0 0 1 0 0 0 x"' 'Lattice="1 0 0 0 1 0 0 0 1" pbc="T T"' \
             'Lattice="1 0 0 0 1 0 0 0 1" pbc="T T X"'; do
  sed "2s/.*/$wrong/" salt.xyz > wrong.xyz
  run wrong.xyz --distance 1 --periodic file
  cause=${wrong##*\" }
  verdict "no cell: $wrong" is_one_error "wrong.xyz:2: ${cause%%=*}: "
  run wrong.xyz --distance 1
  verdict "  unless nobody asks for it" test "$status" -eq 0
done
for wrong in "equator.csv --geographic --distance 1" "ties.csv --distance 1 --memory 1G" \
             "ties.csv --distance 1 --kernel exact" "equator.csv --distance 1 --pairs none.geojson" \
             "equator.csv --distance 1 --points none.geojson" "ties.csv ties.csv --closest" \
             "ties.csv ties.csv --distance 1 --explain" "shapes.wkt --distance 1"; do
  run $wrong --periodic 1,1
  verdict "no --periodic with $wrong" is_one_error "--periodic"
done

# ---------------------------------------------------------------- errors

printf 'x,y\n0,0\n\n,1\n' > hole.csv
printf 'x,y\n0,0\n1,nan\n' > nan.csv
printf 'x,y\n0,0\n1,1e400\n' > huge.csv
printf 'x,y\n0,0\n1\n' > short.csv
printf 'x,y\n0,"0\n' > open_quote.csv
printf 'x,y\n0,a"b,"c\n' > bad_quote.csv
printf 'a,b\n0,0\n' > names.csv
printf 'lat,lon\n10,10\n90.5,10\n' > pole.csv
printf 'x,y\n0.1,0\n0.12345678901234567890,0\n' > long.csv
printf '0 0 0\n# comment\n1 2\n' > short.xyz
printf 'OFF\n3 0 0\n0 0 0\n' > cut.off
printf 'NODE_COORD_SECTION\n1 0 0\n2 zero 0\nEOF\n' > word.tsp
printf 'DIMENSION: 3\nNODE_COORD_SECTION\n1 0 0\n2 1 0\n' > cut.tsp
printf 'TYPE : TSP\n' > head.tsp
printf 'vt 0 0\nf 1 2 3\n' > faces.obj
printf 'HEADER    NO ATOMS\nMODEL        1\nENDMDL\n' > models.pdb
printf '' > nothing.csv
printf '' > names.doc
mkdir directory.csv

expect_error "missing file" "missing.csv: No such file" missing.csv --distance 1
expect_error "a directory" "directory.csv: is a directory" directory.csv --distance 1
expect_error "unknown format" "names.doc: unknown format" names.doc --distance 1
expect_error "no header" "nothing.csv: is empty" nothing.csv --distance 1
expect_error "no number" "word.csv:3: y: 'oops'" word.csv --distance 1
expect_error "no number, as decimals" "word.csv:3: y: 'oops'" word.csv --distance 1 --decimal
expect_error "empty field" "hole.csv:4: x is empty" hole.csv --distance 1
expect_error "NaN" "nan.csv:3: y: 'nan'" nan.csv --distance 1
expect_error "infinity" "infinite.csv:3: y: '-inf'" infinite.csv --distance 1
expect_error "beyond double" "huge.csv:3: y: '1e400'" huge.csv --distance 1
expect_error "short record" "short.csv:3: 1 field, but the header has 2" short.csv --distance 1
expect_error "open quote" "open_quote.csv:2: " open_quote.csv --distance 1
expect_error "misplaced quote" "bad_quote.csv:2: " bad_quote.csv --distance 1
expect_error "no known columns" "names.csv:1: no columns x, y or lat, lon; choose with --columns among a, b" names.csv --distance 1
expect_error "unknown column" "names.csv:1: no column 'c' among a, b" names.csv --distance 1 --columns a,c
expect_error "column number out of range" "no column '3'" names.csv --distance 1 --columns 1,3
expect_error "latitude beyond the pole" "pole.csv:3: lat: latitude 90.5" pole.csv --distance 1 --geographic
printf 'x;y\n1;2\n1;-2,5\n' > decimal_comma.csv
printf '\xFF\xFEx\0,\0y\0\n\0' > wide.csv
ln -s circle.csv circle.csv
printf 'lat,lon\n10,10\n10,-360.5\n' > round.csv
printf '"lat,lon"\n"10,10"\n' > one_column.csv
expect_error "a decimal comma" "decimal_comma.csv:3: y: '-2,5' has a comma in the place of" decimal_comma.csv --distance 1
expect_error "UTF-16" "wide.csv: is in UTF-16; save it in UTF-8" wide.csv --distance 1
expect_error "a link to itself" "near_pairs: circle.csv: Too many levels" circle.csv --distance 1
expect_error "longitude beyond a round" "round.csv:3: lon: longitude -360.5 is outside [-360, 360]" round.csv --distance 1 --geographic
expect_error "latitude and longitude in one column" "no columns lat and lon" one_column.csv --distance 1 --geographic
expect_error "decimals beyond 53 bits" "use --kernel exact" long.csv --distance 1 --decimal
expect_error "short line" "short.xyz:3: 2 numbers" short.xyz --distance 1
expect_error "cut .off file" "cut.off:3: the file ends after vertex 1 of 3" cut.off --distance 1
expect_error "no number in .tsp" "word.tsp:3: x: 'zero'" word.tsp --distance 1
expect_error "cut .tsp file" "cut.tsp:4: 2 nodes" cut.tsp --distance 1
expect_error ".tsp without nodes" "head.tsp: no NODE_COORD_SECTION" head.tsp --distance 1
expect_error ".obj without vertices" "faces.obj: no line of a vertex" faces.obj --distance 1
expect_error ".pdb without atoms" "models.pdb: no line of an atom" models.pdb --distance 1
expect_error "no third axis" "points.tsp:6: " points.tsp --distance 1 --dimension 3
expect_error "no distance" "--distance" ties.csv
expect_error "two distances" "--distance" ties.csv --distance 1 --squared-distance 1
expect_error "a distance and none" "--closest" ties.csv --distance 1 --closest
expect_error "open and no distance" "--open" ties.csv --closest --open
expect_error "closest of one point" "fewer than two points" single.csv --closest
expect_error "closest of none" "fewer than two points" empty.csv --closest
expect_error "negative distance" "-1 is negative" ties.csv --distance -1
expect_error "negative quotient" "1/-3 is negative" ties.csv --squared-distance 1/-3
expect_error "distance is no number" "'1,5' is no number" ties.csv --distance 1,5
expect_error "distance is NaN" "'nan' is no number" ties.csv --distance nan
expect_error "distance is infinite" "'inf' is no number" ties.csv --distance inf
expect_error "division by zero" "'1/0' is no number" ties.csv --distance 1/0
expect_error "absurd exponent" "is no number" ties.csv --distance 1e999999999
expect_error "unknown option" "--distanc" ties.csv --distanc 1
expect_error "unknown kernel" "--kernel: 'float'" ties.csv --distance 1 --kernel float
expect_error "dimension 4" "--dimension" ties.csv --distance 1 --dimension 4
expect_error "dimension is a word" "--dimension" ties.csv --distance 1 --dimension two
expect_error "three files" "one or two input files" ties.csv thirds.csv ties.csv --distance 1
expect_error "no file" "one or two input files" --distance 1

run ties.csv --distance 1 --pairs no/such/place.csv
verdict "unwritable output" is_one_error "no/such/place.csv: "
run ties.csv --distance 1 --pairs directory.csv
verdict "output is a directory" is_one_error "directory.csv: is a directory"
cp ties.csv copy.csv
run copy.csv --distance 1 --pairs copy.csv
verdict "output is the input" is_one_error "copy.csv: is the input file"
verdict "  which is untouched" cmp -s ties.csv copy.csv
if [ -w /dev/full ]; then
  run "$ships" --distance 1 --pairs /dev/full
  verdict "full device" is_one_error "/dev/full: "
  run "$ships" --distance 1 --pairs /dev/full --progress
  ends_early() { [ "$status" -eq 2 ] && grep -q '/dev/full: ' err && ! grep -q '100 %' err; }
  verdict "  ends the search" ends_early
  verdict "  and the line of the percentage" grep -q $'\rnear_pairs: ' err
fi
if (ulimit -v 400000; "$binary" --version > /dev/null 2>&1); then # not under AddressSanitizer
  (ulimit -v 400000; timeout 300 "$binary" /dev/zero --distance 1 > out 2> err)
  status=$?
  verdict "a file that memory does not hold" is_one_error "there is not enough memory"
  head -c 500000000 /dev/zero | gzip -1 > zeros.csv.gz
  (ulimit -v 400000; timeout 300 "$binary" zeros.csv.gz --distance 1 > out 2> err)
  status=$?
  verdict "a line that memory does not hold, compressed" is_one_error "there is not enough memory"
  rm zeros.csv.gz
fi
(ulimit -f 100; exec "$binary" "$ships" --distance 1 --pairs limited.csv > out 2> err)
status=$?
verdict "a file that is too large" is_one_error "limited.csv: cannot be written to its end"
verdict "  and leaves nothing" test -z "$(find . -name 'limited.csv*')"
echo old > old.csv
run word.csv --distance 1 --pairs old.csv
verdict "an error leaves the old output" test "$status $(cat old.csv)" = "2 old"
"$binary" "$ships" --distance 1 --pairs - --picture closed.svg 2> err | head -n 1 > out
status=${PIPESTATUS[0]}
verdict "a pipe that is closed early ends the program by its signal" test "$status" -eq 141
verdict "  quietly" test ! -s err
verdict "  and leaves no temporary file" test -z "$(find . -name 'closed.svg.part*')"
mkfifo pipe
"$binary" "$ships" --distance 1 --pairs - --picture hung.svg > pipe 2> err &
program=$!
exec 9< pipe # holds the program up, when the pipe is full
while kill -0 $program && [ -z "$(find . -name 'hung.svg*')" ]; do sleep 0.1; done
kill -HUP $program
cat <&9 > /dev/null
exec 9<&-
wait $program
status=$?
true > out
verdict "a terminal that hangs up stops the program" is_one_error "stopped"
verdict "  and leaves no file" test -z "$(find . -name 'hung.svg*')"
# Images by the hundred million take minutes; who stops the program waits for a second, or for more
# where many programs run.
printf '2\n\nA 0 0 0\nA 0.5 0.5 0.5\n' > two.xyz
for options in "--distance 300" "--distance 300 --explain" "--distance 300 --parallel"; do
  timeout --preserve-status -s INT -k 20 0.5 \
    "$binary" two.xyz --periodic 1,1,1 $options --pairs interrupted.csv > out 2> err
  status=$?
  verdict "an interrupt stops the making of images: $options" is_one_error "stopped"
  verdict "  and leaves no file" test -z "$(find . -name 'interrupted.csv*')"
done
# A reader that reads nothing holds the program up in the middle of an output.
rm -f pipe
mkfifo pipe
"$binary" "$ships" --distance 1 --pairs - --picture held.svg > pipe 2> err &
program=$!
exec 9< pipe
while kill -0 $program && [ -z "$(find . -name 'held.svg*')" ]; do sleep 0.1; done
sleep 0.2
kill -INT $program
wait $program
status=$?
exec 9<&-
true > out
verdict "an interrupt stops an output that nobody reads" is_one_error "stopped"
verdict "  and leaves no file" test -z "$(find . -name 'held.svg*')"
run two.xyz --periodic 1e-6,1e-6,1e-6 --distance 0.5
verdict "too many images are refused with their number" \
  is_one_error "There are 1e+18 images of points within the bound"
rm -f out
(trap '' PIPE; "$binary" "$ships" --distance 1 --pairs - 2> err; echo $? > ended) | head -n 1 > first
status=$(cat ended)
true > out
verdict "a closed pipe is an error for who ignores the signal" is_one_error "near_pairs: -: "
if [ -w /dev/full ]; then
  for lost in "ties.csv --distance 1" "ties.csv --closest" --help --version; do
    "$binary" $lost > /dev/full 2> err
    status=$?
    verdict "a full standard output: $lost" is_one_error "cannot be written to its end"
  done
fi
"$binary" ties.csv --distance 1 --picture kept.svg >&- 2> err
status=$?
verdict "a closed standard output" is_one_error "the summary: cannot be written"
verdict "  is not mistaken for the picture" grep -q '^</svg>' kept.svg
"$binary" ties.csv --distance 1 --pairs - --picture kept.svg >&- 2> err
status=$?
verdict "pairs to a closed standard output" is_one_error "near_pairs: -: "

# ---------------------------------------------------------------- bytes from strangers

rows() { # COUNT TEXT
  yes "$2" | head -n "$1"
}
digits=$(head -c 100000 /dev/zero | tr '\0' 7)
ply=$'property float x\nproperty int y\nproperty uchar red\nproperty double z\n'
{ printf 'x,y\n"0,0\n'; rows 1250000 1,1; } > stray.csv
{ printf 'x,y\n'; rows 500000 '1"1,1'; } > quotes.csv
{ printf 'x,y\n0,0\n'; head -c 5000000 /dev/zero | tr '\0' ,; } > commas.csv
{ printf '"x\ny\nz",'; head -c 100000 /dev/zero | tr '\0' a; } > names_in_lines.csv
printf 'x,y\n0\0,0\n' > nul.csv
gzip -c nul.csv | gzip -c > twice.csv.gz
printf '\xEF\xBB\xBF"x",y\r\n0,0\r\n\r\n1,0' > quoted_mark.csv
printf '\xEF\xBB\xBF0 0 0\r\n1 0 0' > mark.xyz
printf 'x,y\n%s,0\n' "$digits" > digits.csv
printf 'x,y\n0.%s,0\n1,0\n' "$digits" > decimals.csv
printf 'x,y\n1e999999999,0\n' > exponent.csv
{ printf 'x,y\n1e-1000,0\n'; seq -f '%g,0' 0 9999; } > scales.csv
{ printf '0 0 0 '; head -c 5000000 /dev/zero | tr '\0' ' '; rows 1000000 a | tr '\n' ' '
  printf '\n1 0 0'; } > label.xyz
printf 'DIMENSION : 99999999999999999999\nNODE_COORD_SECTION\n1 0 0\n' > promise.tsp
printf 'COFF\n3 1 0\n0 0 0 255 0 0 # red\n0.5 0 0 0 0 255\n5 5 5 0 0 0\n3 0 1 2 .5 .5 .5\n' > colors.off
printf 'STOFF\r\n2 0 0\r\n0 0 0 .1 .2\r\n0.5 0 0 .3 .4' > textures.off
printf 'STOFF\r\n2 0 0\r\n0 0 0\r\n0.5 0 0' > no_textures.off
printf 'OFF\n1000000000 1000000000 0\n0 0 0\n' > promise.off
printf 'OFF\n-1 0 0\n' > negative.off
printf 'OFF BINARY\n\0\0\0\1\0\0\0\0\0\0\0\0' > binary.off
printf '4OFF\n1 0 0\n0 0 0 0\n' > homogeneous.off
printf "ply\nformat ascii 1.0\nelement vertex 2\n${ply}end_header\n0 0 255 0\n0.5 0 0 0" > colors.ply
printf "ply\nformat binary_little_endian 1.0\nelement l 1\nproperty list uchar short s\n%s" \
       "element vertex 2"$'\n'"${ply}end_header"$'\n' > binary.ply
printf '\2abcd\0\0\0\0\1\0\0\0\377\0\0\0\0\0\0\0\0' >> binary.ply
printf '\0\0\0\77\1\0\0\0\377\0\0\0\0\0\0\0\0' >> binary.ply
head -c -1 binary.ply > cut.ply
printf "ply\nformat binary_big_endian 1.0\nelement vertex 1\n${ply}end_header\n" > nan.ply
printf '\177\300\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0' >> nan.ply
printf "ply\nformat ascii 1.0\nelement vertex 1000000000\n${ply}end_header\n0 0 0 0\n" > promise.ply
printf "ply\nformat ascii 1.0\nelement none 1000000000000000\nelement vertex 0\n${ply}end_header\n" \
       > nothing.ply
printf "ply\nformat binary_big_endian 1.0\nelement l 9\nproperty list uint double s\n%s\377\377\377\377" \
       "element vertex 1"$'\n'"${ply}end_header"$'\n' > list.ply
printf 'ply\nformat ascii 1.0\nproperty float x\nelement vertex 1\nend_header\n0\n' > first.ply
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty int64 x\nend_header\n0\n' > type.ply
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nend_header\n0\n' > line.ply

expect_error "stray quote" "stray.csv:2: field 1: a quote is not closed" stray.csv --distance 1
expect_error "very many quotes" "quotes.csv:2: x: '1\"1' is no finite number" quotes.csv --distance 1
expect_error "a line of commas" "commas.csv:3: 5000001 fields" commas.csv --distance 1
expect_error "long names with line ends" "among x?y?z, aaa" names_in_lines.csv --distance 1
verdict "  of which the beginning is shown" test "$(wc -c < err)" -lt 1000
expect_error "a compressed file that was compressed" "twice.csv.gz:1: is no text" twice.csv.gz --distance 1
expect_error "a zero byte" "nul.csv:2: x: '0?' is no" nul.csv --distance 1
expect_pairs "byte order mark before a quote" 1 quoted_mark.csv --distance 1
expect_pairs "byte order mark in .xyz" 1 mark.xyz --distance 1
expect_error "10^5 digits" "digits.csv:2: x: '777" digits.csv --distance 1
expect_scene "10^5 decimals" 2 1 decimals.csv --distance 0.2222222222222223
expect_error "  as decimals" "decimals.csv:2: --decimal: 0.777" decimals.csv --distance 1 --decimal
expect_scene "  exactly" 2 0 decimals.csv --distance 0.2222222222222222 --decimal --kernel exact
expect_error "10^5 digits, as decimals" "digits.csv:2: x: '777" digits.csv --distance 1 --decimal
expect_error "10^5 digits, exactly" "digits.csv:2: x: '777" digits.csv --distance 1 --decimal --kernel exact
expect_pairs "10^4 integers and 1e-1000, exactly" 1 scales.csv --distance 0.5 --decimal --kernel exact
expect_pairs "  and its ties" 10001 scales.csv --distance 1 --decimal --kernel exact --dimension 2
expect_error "exponent of nine digits" "exponent.csv:2: x: '1e999999999'" exponent.csv --distance 1
expect_error "the same, exactly" "exponent.csv:2: x: '1e9" exponent.csv --distance 1 --decimal --kernel exact
expect_pairs "a label of 10^6 words" 1 label.xyz --distance 1
expect_error ".tsp promises more" "promise.tsp:1: DIMENSION: '99999999999999999999' is no count" promise.tsp --distance 1
expect_pairs ".off with colors" 1 colors.off --distance 0.5
expect_pairs "  as decimals" 1 colors.off --distance 0.5 --decimal
expect_pairs ".off with textures" 1 textures.off --distance 0.5
expect_error "  but none there" "no_textures.off:4: the file ends after vertex 1 of 2" no_textures.off --distance 1
expect_error ".off promises 10^9 vertices" "the file ends after vertex 1 of 1000000000" promise.off --distance 1
expect_error ".off with fewer than none" "negative.off:2:1: '-1' is no count" negative.off --distance 1
expect_error "binary .off, cut" "binary.off:1: the file ends after vertex 0 of 1" binary.off --distance 1
expect_error ".off in projective space" "homogeneous.off:1:1: vertices with four" homogeneous.off --distance 1
expect_pairs ".ply of integers, with colors" 1 colors.ply --distance 0.5
expect_pairs "binary .ply, behind a list" 1 binary.ply --distance 0.5
expect_error "binary .ply, a byte less" "cut.ply:10: the file ends after vertex 1 of 2" cut.ply --distance 1
expect_error "binary .ply, as decimals" "--decimal needs" binary.ply --distance 1 --decimal
expect_error "binary .ply, NaN" "nan.ply: vertex 0 (from 0) has a coordinate that is no" nan.ply --distance 1
expect_error ".ply promises 10^9 vertices" "the file ends after vertex 1 of 1000000000" promise.ply --distance 1
expect_pairs ".ply promises 10^15 times nothing" 0 nothing.ply --distance 1
expect_error ".ply promises a long list" "the file ends after l 0 of 9" list.ply --distance 1
expect_error ".ply with a property of nothing" "first.ply:3: no line of a header" first.ply --distance 1
expect_error ".ply with a type of 64 bits" "type.ply:4: unknown type 'int64'" type.ply --distance 1
expect_error ".ply on a line" "the vertices have no property y" line.ply --distance 1

# ---------------------------------------------------------------- kernels, and many points

expect_pairs "decimals beyond 53 bits, exact kernel" 1 long.csv --decimal --kernel exact --distance 0.0234567890123456789
expect_boundary 1
expect_pairs "  and a hair less" 0 long.csv --decimal --kernel exact --distance 0.0234567890123456788

for kernel in epick exact; do
  expect_pairs "ships, 0.00069 degrees, $kernel" 4931 "$ships" --decimal --distance 0.00069 \
               --kernel $kernel --pairs $kernel.csv
  expect_boundary 0
  verdict "  the same as epick" same_pairs $kernel.csv epick.csv
  expect_closest "ships, $kernel" "6137 7521, 6137 and 7521" 0.0000000002 "$ships" --decimal --kernel $kernel
  run ties.csv --distance 0.1 --kernel $kernel --pairs ties_$kernel.csv
  verdict "  also on the tenths as doubles" same_pairs ties_$kernel.csv ties_epick.csv
done
expect_pairs "ships, 0.019 degrees" 101850 "$ships" --decimal --distance 0.019
expect_pairs "ships, 0.00069 degrees, open" 4931 "$ships" --decimal --distance 0.00069 --open
expect_pairs "ships, 69 m on the sphere" 5092 "$ships" --geographic --distance 69 --pairs sphere.csv

run "$ships" --decimal --distance 0.00069 --parallel --pairs parallel.csv
if grep -q "built without TBB" err; then
  verdict "--parallel is refused without TBB" is_one_error "--parallel"
else
  verdict "ships in parallel" test "$status $(summary pairs)" = "0 4931"
  verdict "  the same as in sequence" same_pairs parallel.csv epick.csv
  run "$ships" --geographic --distance 69 --parallel --pairs parallel.csv
  verdict "  also on the sphere" same_pairs parallel.csv sphere.csv
fi

# ---------------------------------------------------------------- beyond memory

# A large shell becomes the program, which is small.
(big=$(printf '%0200000000d' 0); exec "$binary" ties.csv --distance 1 > out 2> err)
small_peak() { summary "peak memory" | awk '{ exit !($1 > 1 && $1 < 150) }'; }
verdict "peak memory of the program alone" small_peak

zero='\0\0\0\0\0\0\0\0'
one='\0\0\0\0\0\0\xf0\x3f'
two='\0\0\0\0\0\0\0\x40'
nan='\0\0\0\0\0\0\xf8\x7f'
printf "$zero$zero$zero$one$zero$zero$one$two$zero" > three.bin
printf "$zero$zero$zero$one$zero$nan" > nan.bin
{ cat three.bin; printf .; } > long.bin
expect_pairs "binary points" 1 three.bin --distance 1
expect_pairs "  at most 2 apart" 2 three.bin --distance 2
expect_pairs "  in the plane of x and y" 2 three.bin --distance 2 --dimension 2
expect_pairs "  by another name" 1 <(cat three.bin) --format bin --distance 1
expect_error "binary NaN" "nan.bin: point 1: z is no finite number" nan.bin --distance 1
expect_error "part of a point" "long.bin: ends inside a point" long.bin --distance 1
expect_error "binary decimals" "--decimal is for numbers" three.bin --distance 1 --decimal
expect_error "binary columns" "--columns needs a table" three.bin --distance 1 --columns x,y

# The least memory that the program takes, as it says itself, is too small for these points.
awk 'BEGIN { srand(1); print "x,y,z"; for(i = 0; i < 150000; ++i) print rand() "," rand() "," rand() }' > many.csv
run many.csv --distance 0.005 --memory 1K --pairs -
verdict "too little memory" is_one_error "--memory: the program itself takes "
verdict "  and prints nothing" test ! -s out
memory=$(sed 's/.* takes //' err)
mkdir scratch
run many.csv --distance 0.005 --pairs many_pairs.csv
run many.csv --distance 0.005 --memory "$memory" --scratch scratch --pairs part_pairs.csv
verdict "points beyond the memory" test "$status $(summary points)" = "0 150000"
verdict "  have the same pairs" same_pairs many_pairs.csv part_pairs.csv
verdict "  and leave no scratch file" test -z "$(ls -A scratch)"
run three.bin --distance 2 --memory 1G --pairs -
verdict "pairs of points that fit" test "$(tail -n +2 out | sort | tr '\n' ' ')" = "0,1 1,2 "
verdict "  of which no ids and distances are written" grep -q 'hint: .* without ids and distances' err
verdict "  and ties are not counted" grep -q '^on boundary  not counted' err
run long.bin --distance 1 --memory 1G
verdict "part of a point" is_one_error "long.bin: ends inside a point"
run nan.bin --distance 1 --memory 1G
verdict "a NaN" is_one_error "nan.bin: point 1: z is no finite number"
run <(cat three.bin) --format bin --distance 1 --memory 1G
verdict "a pipe" is_one_error "--memory is for a regular file"
awk 'BEGIN { print "x,y"; for(i = 1000000; i < 4000000; ++i) print i ",0" }' > cut.csv
"$binary" cut.csv --distance 0 --memory 1G > out 2> err &
sleep 0.1
truncate -s 1M cut.csv
wait $!
status=$?
verdict "a file that is cut while it is read" is_one_error " bytes, and had 30000004 when it was opened"
run many.csv --distance 1 --memory "$memory"
verdict "a crowd beyond the memory" is_one_error "take a larger budget or a smaller bound"
run many.csv --distance 0.005 --memory "$memory" --scratch no/such/place
verdict "no folder for scratch" is_one_error "The scratch file in no/such/place cannot be made"
(trap '' XFSZ; ulimit -f 100; exec "$binary" many.csv --distance 0.005 --memory "$memory" --scratch scratch \
   > out 2> err)
status=$?
verdict "a scratch file that is too large" is_one_error "The scratch file in scratch cannot be written"
verdict "  and leaves nothing" test -z "$(ls -A scratch)"
run "$ships" --geographic --distance 69 --memory 1G
verdict "ships by a budget" test "$status $(summary pairs)" = "0 5092"
if [ -w /dev/full ]; then
  run "$ships" --geographic --distance 500 --memory 1G --pairs /dev/full --progress
  verdict "a full device ends the search" ends_early
fi
for wrong in "--memory 5X" "--memory 0" "--scratch ." "--memory 1G --components" \
             "--memory 1G --points points.csv" "--memory 1G --skip-missing" "--memory 1G --decimal" "--memory 1G ties.csv"; do
  run many.csv --distance 1 $wrong
  verdict "refused: $wrong" is_one_error "--${wrong:2:6}"
done
run - --distance 1 --memory 1G < ties.csv
verdict "the standard input is read once" is_one_error "--memory is for one file"

echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
