#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Voronoi diagram of more circles than one memory holds: in tiles, by Dask.

    tiles.py CIRCLES.csv FOLDER --size 1000 --halo 30
    tiles.py CIRCLES.csv FOLDER --size 1000 --halo 30 --scheduler tcp://node1:8786

The program cuts the circles into tiles (FOLDER/0/tiles). A worker computes each tile: a process on this machine, or on a
Dask cluster whose machines share the folder. The final parts of a tile are written to FOLDER/0/parts. Some circles are not
final yet: huge circles, and circles at the rim of the whole or of holes wider than the halo. They go on to the next level
(FOLDER/1) together with their neighbors. Tiles of the next level are wider; once at most --most circles are left, there is
only one tile. FOLDER/*/parts together are the diagram, each line once.

A failed tile is tried again, also if its worker was killed. After an interruption, run the same command again: it skips
the finished tiles, because parts are only ever written as a whole.
"""

import argparse
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

from distributed import Client, LocalCluster, as_completed

PLANE = "-inf,-inf,inf,inf"
CIRCLES_ARE_LEFT = 3  # an exit status
RETRIES = 3
WIDER = 8  # tiles of the next level


def run(*command):
    done = subprocess.run([str(word) for word in command], stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, CIRCLES_ARE_LEFT):
        raise RuntimeError(done.stderr.strip() or f"{command[0]} ended with status {done.returncode}.")


def cut(program, circles, level, size, halo):
    """Returns the tiles of a level, and cuts them first unless their list exists, which is written last."""
    tiles = level / "tiles"
    if not (tiles / "tiles.txt").exists():
        shutil.rmtree(tiles, ignore_errors=True)
        run(program, "tile", circles, "--size", size, "--halo", halo, "-o", tiles)
    return [line.split() for line in (tiles / "tiles.txt").read_text().splitlines()]


def compute(program, circles, part, left, core, known, options):
    """Writes the final parts of the core, after writing the circles that are not final."""
    to_left = ["--open", left] if left else []
    run(program, "compute", circles, f"--known={known}", f"--core={core}", "--max-radius=0", *to_left, "-o", part, *options)


def compute_tiles(client, level, tiles, task, ending):
    """Computes the unfinished tiles of a level, and shows the number of finished tiles."""
    for folder in ("open", "parts"):
        (level / folder).mkdir(exist_ok=True)
    begin, done = time.time(), 0
    waiting = []
    for name, _, core, known in sorted(tiles, key=lambda tile: -int(tile[1])):  # the largest first
        part = level / "parts" / f"{name}.{ending}"
        if part.exists():
            done += 1
        else:
            files = [str(file) for file in (level / "tiles" / f"{name}.csv", part, level / "open" / f"{name}.csv")]
            waiting.append(client.submit(task, *files, core, known, retries=RETRIES, pure=False))
    show(done, len(tiles), begin)
    for future in as_completed(waiting):
        future.result()  # throws the exception of the task
        done += 1
        show(done, len(tiles), begin)
    keep_only(level / "parts", [f"{name}.{ending}" for name, *_ in tiles])


def keep_only(folder, names):
    """Removes all other files, which killed programs left incomplete."""
    for file in folder.iterdir():
        if file.name not in names:
            file.unlink(missing_ok=True)


def show(done, tiles, begin):
    is_over = done == tiles
    if is_over or sys.stderr.isatty():
        bar = "#" * (30 * done // tiles)
        print(f"\r[{bar:30}] {done} of {tiles} tiles, {time.time() - begin:.0f} s", end="\n" if is_over else "", file=sys.stderr)


def gather(level, tiles, circles):
    """Writes the circles that are not final after a level, and returns their number.

    It reads only the files of the tiles, because killed programs may have left incomplete files beside them.
    """
    count = 0
    circles.parent.mkdir(exist_ok=True)
    with open(circles, "w") as out:
        out.write("id,x,y,r,done\n")
        for name in sorted(name for name, *_ in tiles):
            with open(level / "open" / f"{name}.csv") as lines:
                next(lines)
                for line in lines:
                    out.write(line)
                    count += 1
    return count


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("circles", help="a table with the columns x, y, r and perhaps id")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--size", type=float, required=True, help="the side of a tile, with about a million circles in each tile")
    parser.add_argument("--halo", type=float, required=True, help="about ten times the distance between neighbors")
    parser.add_argument("--most", type=int, default=5_000_000, help="the largest number of circles in the last tile")
    parser.add_argument("--bounds", help="write cells clipped to this box as lines of GeoJSON, instead of vertices and edges as CSV")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), help="processes on this machine")
    parser.add_argument("--scheduler", help="the address of a Dask cluster to use instead")
    parser.add_argument("--program", default="circle-voronoi")
    arguments = parser.parse_args()
    program, folder = arguments.program, arguments.folder.resolve()
    ending = "geojsonl" if arguments.bounds else "csv"
    options = ["--format", ending, *([f"--bounds={arguments.bounds}"] if arguments.bounds else [])]

    def task(circles, part, left, core, known):
        compute(program, circles, part, left, core, known, options)

    cluster = None if arguments.scheduler else LocalCluster(n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None)
    with Client(arguments.scheduler or cluster) as client:
        circles, size, halo, level = arguments.circles, arguments.size, arguments.halo, folder / "0"
        while True:
            level.mkdir(parents=True, exist_ok=True)
            tiles = cut(program, circles, level, size, halo)
            compute_tiles(client, level, tiles, task, ending)
            size, halo, next_level = WIDER * size, WIDER * halo, folder / str(int(level.name) + 1)
            left = gather(level, tiles, next_level / "circles.csv")
            level, circles = next_level, next_level / "circles.csv"
            if left <= arguments.most or len(tiles) == 1:
                break
        (level / "parts").mkdir(exist_ok=True)
        part = level / "parts" / f"all.{ending}"
        client.submit(task, str(circles), str(part), None, PLANE, PLANE, retries=RETRIES, pure=False).result()
        keep_only(level / "parts", [part.name])
    if cluster:
        cluster.close()
    print(f"{folder}/*/parts: done; {left} circles in the last tile.", file=sys.stderr)


if __name__ == "__main__":
    main()
