#!/usr/bin/env python3
"""Front and heights of liquids over time, from sequences and from states of ./run play, as CSV.

    compare.py --box MANIFEST NAME=SEQUENCE... NAME=STATE@SECONDS...

A sequence is a folder with sequence.json, in metres from the centre of the box; a state is a PLY
file of ./run play --state, in the world. The front is the largest x of the liquid, less the 16
particles that are farthest; heights are means of the highest eighth of the particles in columns
of a tenth of the box's length at its left end, in its middle and at its right end.
"""
import argparse
import csv
import json
import os
import sys

import numpy as np

TYPES = {'float': '<f4', 'uint': '<u4', 'int': '<i4', 'double': '<f8', 'uchar': 'u1'}


def read_ply(file):
    with open(file, 'rb') as stream:
        count, columns = 0, []
        while (line := stream.readline().split()) != [b'end_header']:
            if line[:2] == [b'element', b'vertex']:
                count = int(line[2])
            if line[:1] == [b'property']:
                columns.append((line[2].decode(), TYPES[line[1].decode()]))
        return np.fromfile(stream, np.dtype(columns), count)


def figures(place, box):
    """Front over the left end of the box, and three heights over its floor [m]."""
    x, y = place[0] + box[0]/2, place[1] + box[1]/2
    result = [np.sort(x)[-17] if len(x) > 16 else np.nan]
    for centre in (0.05, 0.5, 0.95):
        column = np.sort(y[np.abs(x/box[0] - centre) < 0.05])
        result.append(column[-max(1, len(column)//8):].mean() if len(column) else 0.0)
    return result


def frames(source, box):
    """Time and places in the box."""
    if os.path.isdir(source):
        with open(os.path.join(source, 'sequence.json')) as file:
            index = json.load(file)
        for frame in index['frames']:
            table = read_ply(os.path.join(source, frame['file']))
            yield frame['time'], np.array([table[axis] for axis in 'xyz'], float)
        return
    file, time = source.rsplit('@', 1)
    table = read_ply(file)
    place = np.array([table[axis] for axis in 'xyz'], float) - np.array(box['position'])[:, None]
    yield float(time), place  # boxes that are turned are not compared


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--box', required=True, help='manifest.json of the export')
    parser.add_argument('sources', nargs='+')
    given = parser.parse_args()
    with open(given.box) as file:
        box = json.load(file)
    writer = csv.writer(sys.stdout, lineterminator='\n')
    writer.writerow(['time_s', 'source', 'particles', 'front_m', 'height_left_m', 'height_middle_m', 'height_right_m'])
    rows = []
    for source in given.sources:
        name, path = source.split('=', 1)
        for time, place in frames(path, box):
            rows.append([round(time, 6), name, place.shape[1]] + ['%.4f' % value for value in figures(place, box['domainSize'])])
    for row in sorted(rows, key=lambda r: (r[0], r[1])):
        writer.writerow(row)


if __name__ == '__main__':
    main()
