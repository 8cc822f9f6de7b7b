#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes a diagram in tiles with xargs alone: tiles.sh CIRCLES.csv SIZE HALO FOLDER [PROCESSES]
set -eu
export FOLDER="$4" PROGRAM="${CIRCLE_VORONOI:-circle-voronoi}"
mkdir -p "$FOLDER/open" "$FOLDER/parts"
"$PROGRAM" tile "$1" --size "$2" --halo "$3" -o "$FOLDER/tiles"
# A status of 3 says that circles are left; they are in open/.
xargs -P "${5:-$(nproc)}" -L 1 sh -c '"$PROGRAM" compute "$FOLDER/tiles/$0.csv" --core="$2" --known="$3" --max-radius 0 \
  --open "$FOLDER/open/$0.csv" -o "$FOLDER/parts/$0.csv" 2>/dev/null || [ $? = 3 ]' < "$FOLDER/tiles/tiles.txt"
{ echo id,x,y,r,done; find "$FOLDER/open" -name '*.csv' -exec tail -q -n +2 {} +; } > "$FOLDER/rest.csv"
"$PROGRAM" compute "$FOLDER/rest.csv" --known=-inf,-inf,inf,inf --max-radius 0 -o "$FOLDER/parts/rest.csv"
