#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Time, memory and disk of MILLIONS of circles in tiles: measure.sh FOLDER MILLIONS PROCESSES
# The circles stream into the tiles. The output of each tile is counted and hashed, not kept.
set -euo pipefail
millions=$2
export FOLDER=$1 PROGRAM=${CIRCLE_VORONOI:-circle-voronoi}
mkdir -p "$FOLDER/open" "$FOLDER/sums"
# For each process, with its libraries.
ulimit -v 900000
TIMEFORMAT='%R s, %U s of processors, %S s in the system'

circles() { # one in each cell of a square grid
  mawk -v n="$millions" 'BEGIN {
    srand(1); side = int(sqrt(n * 1e6)); print "x,y,r"
    for (y = 0; y < side; ++y) for (x = 0; x < side; ++x)
      printf "%.6f,%.6f,%.6f\n", x + 0.6 * rand(), y + 0.6 * rand(), 0.2 * rand()
  }'
}

echo 'cut:'
[ -f "$FOLDER/tiles/tiles.txt" ] || time circles | "$PROGRAM" tile - --size 1000 --halo 12 -o "$FOLDER/tiles"
du -sh "$FOLDER/tiles"

compute() { # of a tile: the counts of what it writes, and a hash
  "$PROGRAM" compute "$FOLDER/tiles/$1.csv" --core="$2" --known="$3" --max-radius 0 --open "$FOLDER/open/$1.csv" --format csv \
    2> /dev/null | tee >(md5sum > "$FOLDER/sums/$1.md5") | mawk -F, '{ ++count[$1] } END { print count["vertex"] + 0, count["edge"] + 0, count["hidden"] + 0 }' > "$FOLDER/sums/$1.txt"
}
export -f compute
echo "compute, $3 processes:"
time xargs -P "$3" -L 1 bash -c 'compute "$0" "$2" "$3"' < "$FOLDER/tiles/tiles.txt"

echo 'the rest:'
{ echo id,x,y,r,done; find "$FOLDER/open" -name '*.csv' -exec tail -q -n +2 {} +; } > "$FOLDER/rest.csv"
cp "$FOLDER/rest.csv" "$FOLDER/tiles/rest.csv"
time compute rest -inf,-inf,inf,inf -inf,-inf,inf,inf
wc -l < "$FOLDER/rest.csv"

echo 'vertices, edges, hidden circles; edges - vertices + hidden + 1, which Euler says is the number of circles:'
cat "$FOLDER"/sums/*.txt | mawk '{ v += $1; e += $2; h += $3 } END { printf "%.0f %.0f %.0f %.0f\n", v, e, h, e - v + h + 1 }'
cat "$FOLDER"/sums/*.md5 | sort | md5sum
