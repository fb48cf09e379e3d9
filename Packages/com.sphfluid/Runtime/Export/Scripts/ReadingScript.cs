namespace SphFluid
{
    /// <summary>readings.py: what the scene's probes and gauges read of PySPH's output. Names between @ are replaced.</summary>
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
import sys

import numpy as np
from pysph.solver.utils import get_files, load
from pysph.tools.interpolator import Interpolator

dx, rho0 = @SPACING@, @DENSITY@
# name, property, place, and of a gauge its direction and length
probes = [
@PROBES@]
gauges = [
@GAUGES@]


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
    readers = [(name, prop, Reader(None if prop == 'p' else ['liquid'], [place], 'shepard')) for name, prop, place in probes]
    lines = []
    for name, place, up, length in gauges:
        steps = np.linspace(0, length, int(np.ceil(2*length/dx)) + 2)
        lines.append((name, length, Reader(['liquid'], np.array(place) + steps[:, None]*np.array(up), 'sph')))
    with open(table, 'w', newline='') as file:
        writer = csv.writer(file)
        writer.writerow(['time_s'] + ['%s.%s' % (name, prop) for name, prop, _ in probes] + [g[0] + '.height_m' for g in gauges])
        for frame in get_files(out, 'case'):
            data = load(frame)
            arrays = data['arrays']
            writer.writerow(
                ['%.9g' % float(data['solver_data']['t'])] + ['%.9g' % reader.read(arrays, prop)[0] for _, prop, reader in readers] +
                ['%.9g' % height(reader.read(arrays, 'rho'), length) for _, length, reader in lines])
    print('readings of %d instruments in %s' % (len(probes) + len(gauges), table))


if __name__ == '__main__':
    main(*sys.argv[1:])
";
    }
}
