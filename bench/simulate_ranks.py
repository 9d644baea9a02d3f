#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
# How long would so many ranks take for a run whose paths were measured on one? A simulation: no machine of that size was there.
#
#   moivre solve FILE --threads 1 --paths paths.csv --json run.json
#   bench/simulate_ranks.py paths.csv SECONDS_OF_PATHS [SECONDS_BETWEEN_LISTS]
#
# A path takes its share of the seconds by its steps. Blocks of 4096 paths, and pieces as src/mpi_ranks/job_board.cpp hands them out. A piece
# costs a rank kClaim; an outcome costs rank 0 kOfRank0, and is sent on over links of kBytesASecond, twice by each rank.
import csv
import heapq
import sys

BLOCK = 4096
PIECES_OF_A_SHARE, MOST_OF_A_PIECE = 2, 512
CLAIM = 0.5e-3  # between two looks of rank 0 and of the rank
OF_RANK_0 = 5e-6  # measured, its looks included
OUTCOME = 400  # bytes
BYTES_A_SECOND = 10e9
LATENCY = 0.3e-3  # a level of the tree: half of the time between two looks


def block_seconds(paths, ranks):
    """Until the last rank knows the last end of these paths, begun together."""
    free_at = [(0.0, rank) for rank in range(min(ranks, len(paths)))]
    heapq.heapify(free_at)
    next_path, last = 0, 0.0
    board = 0.0  # rank 0 answers one after the other
    while next_path < len(paths):
        now, rank = heapq.heappop(free_at)
        left = len(paths) - next_path
        piece = max(1, min(left // (PIECES_OF_A_SHARE * ranks), MOST_OF_A_PIECE))
        board = max(board, now) + OF_RANK_0
        end = board + CLAIM + sum(paths[next_path : next_path + piece])
        next_path += piece
        last = max(last, end)
        heapq.heappush(free_at, (end, rank))
    busy = len(paths) * max(OF_RANK_0, 2 * OUTCOME / BYTES_A_SECOND)
    levels = max(1, ranks).bit_length() - 1
    return max(last, busy) + levels * LATENCY


def main():
    seconds = float(sys.argv[2])
    between = float(sys.argv[3]) if len(sys.argv) > 3 else 0.0
    with open(sys.argv[1], newline="") as file:
        steps = [int(row["steps"]) for row in csv.DictReader(file)]
    paths = [seconds * each / sum(steps) for each in steps]
    for ranks in (1, 2, 4, 16, 64, 256, 1024, 4096):
        time = between
        for first in range(0, len(paths), BLOCK):
            time += block_seconds(paths[first : first + BLOCK], ranks)
        speed = (seconds + between) / time
        print(f"{ranks:5d} ranks: {time:9.3f} s, {speed:7.1f} times as fast, {100 * speed / ranks:5.1f} % of each")


if __name__ == "__main__":
    main()
