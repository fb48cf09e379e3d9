namespace SphFluid
{
    /// <summary>readings.py: what the scene's probes and gauges read of PySPH's output. The same for every case.</summary>
    internal static class ReadingScript
    {
        public const string Text = @"#!/usr/bin/env python3
'''What the scene's probes and gauges read of the liquid that case.py computed: readings.csv.

    python3 readings.py [out] [readings.csv]

By PySPH's Interpolator. Pressure is the mean about a point of liquid and walls, as in
pysph/examples/dam_break_3d.py; a gauge's height is where the density of the lowest liquid on
its line falls below half the rest density. Positions in metres from the centre of the box.
'''
import csv
import json
import os
import sys

import numpy as np
from pysph.solver.utils import get_files, load
from pysph.tools.interpolator import Interpolator

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), 'manifest.json'), encoding='utf-8') as file:
    given = json.load(file)
dx, rho0 = given['spacing'], given['density']
probes = [reading for reading in given['readings'] if reading['property'] != 'height']
gauges = [reading for reading in given['readings'] if reading['property'] == 'height']


class Reader:
    '''An interpolator that is compiled once and asked of every frame.'''

    def __init__(self, names, points, method):
        self.names, self.points, self.method, self.tool = names, np.array(points, float), method, None

    def read(self, arrays, name):
        chosen = [arrays[n] for n in arrays if self.names is None or n in self.names]
        if self.tool is None:
            x, y, z = np.ascontiguousarray(self.points.T)
            self.tool = Interpolator(chosen, x=x, y=y, z=z, method=self.method)
        else:
            self.tool.update_particle_arrays(chosen)
        return np.atleast_1d(self.tool.interpolate(name))


def height(density, length):
    steps = np.linspace(0, length, len(density))
    wet = density >= 0.5*rho0
    if not wet.any():
        return 0.0
    first = int(np.argmax(wet))  # of a gauge on the floor the first points have half of their surroundings in it
    dry = np.nonzero(~wet[first:])[0]
    if len(dry) == 0:
        return length
    k = first + dry[0]
    return float(np.interp(0.5*rho0, [density[k], density[k - 1]], [steps[k], steps[k - 1]]))


def main(out='out', table='readings.csv'):
    readers = [(p['property'], Reader(None if p['property'] == 'p' else ['liquid'], [p['place']], 'shepard')) for p in probes]
    lines = []
    for gauge in gauges:
        steps = np.linspace(0, gauge['length'], int(np.ceil(2*gauge['length']/dx)) + 2)
        points = np.array(gauge['place']) + steps[:, None]*np.array(gauge['up'])
        lines.append((gauge['length'], Reader(['liquid'], points, 'sph')))
    with open(table, 'w', newline='', encoding='utf-8', errors='backslashreplace') as file:
        writer = csv.writer(file)
        writer.writerow(['time_s'] + ['%s.%s' % (p['name'], p['property']) for p in probes] + [g['name'] + '.height_m' for g in gauges])
        for frame in get_files(out, 'case'):
            data = load(frame)
            arrays = data['arrays']
            writer.writerow(
                ['%.9g' % float(data['solver_data']['t'])] + ['%.9g' % reader.read(arrays, prop)[0] for prop, reader in readers] +
                ['%.9g' % height(reader.read(arrays, 'rho'), length) for length, reader in lines])
    print('readings of %d instruments in %s' % (len(probes) + len(gauges), table))


if __name__ == '__main__':
    main(*sys.argv[1:])
";
    }
}
