namespace SphFluid
{
    /// <summary>to_sequence.py: what PySPH wrote, or VTK files of another engine, as a sequence that Fluid Playback plays. The same for every case.</summary>
    internal static class SequenceScript
    {
        public const string Text = @"#!/usr/bin/env python3
'''Particles over time as a sequence for Fluid Playback: sequence.json and a PLY file a frame.

    python3 to_sequence.py [out] [sequence]                            what case.py wrote to out
    python3 to_sequence.py --vtk 'run/*.vtu' --frame-rate 30 sequence  files that meshio reads

Points of VTK files are metres from the centre of the box; velocities are read from point data
named velocity, Velocity or U, numbers of particles from id, Id or gid. What files do not have is
left out of the sequence: without velocities particles go straight from frame to frame, without
numbers frames are shown as they are.
'''
import argparse
import glob
import json
import os
import zlib

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
VELOCITY, NUMBER = ('vx', 'vy', 'vz'), 'id'


def rows(place, velocity=None, ids=None):
    '''Rows in order of their numbers, without the columns that are not known.'''
    columns = dict(zip('xyz', place))
    columns.update(zip(VELOCITY, velocity) if velocity is not None else ())
    columns.update({NUMBER: ids} if ids is not None else {})
    table = np.empty(len(columns['x']), [(name, '<u4' if name == NUMBER else '<f4') for name in columns])
    for column, values in columns.items():
        table[column] = values
    return table if ids is None else table[np.argsort(table[NUMBER], kind='stable')]


def pysph_frames(folder):
    from pysph.solver.utils import get_files, load
    files = get_files(folder, 'case')
    if not files:
        raise SystemExit(""no output of case.py in '%s': run it first."" % folder)
    for file in files:
        data = load(file)
        a = data['arrays']['liquid']
        yield float(data['solver_data']['t']), rows((a.x, a.y, a.z), (a.u, a.v, a.w), a.liquid_id)


def vtk_frames(pattern, frame_rate):
    try:
        import meshio
    except ImportError:
        raise SystemExit('--vtk reads files by meshio: apt-get install python3-meshio')
    files = sorted(glob.glob(pattern))
    if not files:
        raise SystemExit(""--vtk: no file matches '%s'."" % pattern)
    for number, file in enumerate(files):
        mesh = meshio.read(file)
        found = {name.lower(): values for name, values in mesh.point_data.items()}
        velocity = next((found[name] for name in ('velocity', 'u') if name in found), None)
        ids = next((np.ravel(found[name]) for name in ('id', 'gid') if name in found), None)
        if number == 0 and velocity is None:
            print('%s has no velocities: particles go straight from frame to frame.' % file)
        if number == 0 and ids is None:
            print('%s has no numbers of particles: frames are shown as they are.' % file)
        if velocity is not None and np.shape(velocity) != mesh.points.shape:
            raise SystemExit('%s: velocities are %s numbers, the points %s.' % (
                file, np.shape(velocity), mesh.points.shape))
        if ids is not None and len(np.unique(ids)) != len(mesh.points):
            raise SystemExit('%s: %d points, but %d different numbers of particles.' % (
                file, len(mesh.points), len(np.unique(ids))))
        yield number/frame_rate, rows(mesh.points.T, velocity if velocity is None else velocity.T, ids)


def keep(table, manifest, time):
    '''Without what has left through open faces; what else is amiss is said.'''
    place = np.array([table[axis] for axis in 'xyz'])
    if not np.isfinite(place).all():
        raise SystemExit('%d particles have no finite position at %g s: the run has failed.' % (
            (~np.isfinite(place)).any(axis=0).sum(), time))
    half = np.array(manifest['domainSize'])/2
    gone = np.zeros(len(table), bool)
    for number, axis in enumerate('XYZ'):
        for side, name in ((-1, 'Low' + axis), (1, 'High' + axis)):
            if name in manifest['openFaces']:
                gone |= side*place[number] > half[number]
    outside = (~gone & (np.abs(place) > half[:, None]).any(axis=0)).sum()
    if outside:
        print('%g s: %d particles are outside of the box, though no open face is there.' % (time, outside))
    return table[~gone]


def write(frames, manifest, source, folder):
    os.makedirs(folder, exist_ok=True)
    index = os.path.join(folder, 'sequence.json')
    for old in [index] + glob.glob(os.path.join(folder, 'frame-*.ply')):
        if os.path.exists(old):
            os.remove(old)
    entries = []
    for time, table in frames:
        if entries and time <= entries[-1]['time']:
            continue  # a run's end is written twice where it is a frame's time
        table = keep(table, manifest, time)
        name = 'frame-%05d.ply' % len(entries)
        properties = ''.join('property %s %s\n' % ('uint' if p == NUMBER else 'float', p) for p in table.dtype.names)
        contents = ('ply\nformat binary_little_endian 1.0\nelement vertex %d\n%send_header\n' % (
            len(table), properties)).encode() + table.tobytes()
        with open(os.path.join(folder, name), 'wb') as file:
            file.write(contents)
        entries.append({'file': name, 'time': time, 'particles': len(table), 'bytes': len(contents),
                        'crc32': '%08x' % zlib.crc32(contents)})
    with open(index + '.part', 'w') as file:
        json.dump({'format': 'sphfluid-sequence', 'version': 1, 'source': source, 'spacing': manifest['spacing'],
                   'domainSize': manifest['domainSize'], 'frames': entries}, file, indent=1)
    os.replace(index + '.part', index)  # a folder that has it is whole
    print('%d frames, %d particles in the last, in %s' % (len(entries), entries[-1]['particles'], folder))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('folders', nargs='*', help=""PySPH's output and the sequence; with --vtk the sequence"")
    parser.add_argument('--vtk', metavar='PATTERN', help='files of another engine')
    parser.add_argument('--frame-rate', type=float, help=""frames a second of --vtk (default: the case's)"")
    given = parser.parse_args()
    with open(os.path.join(HERE, 'manifest.json'), encoding='utf-8') as file:
        manifest = json.load(file)
    if given.vtk:
        frames = vtk_frames(given.vtk, given.frame_rate or manifest['frameRate'])
        write(frames, manifest, 'VTK files ' + given.vtk, (given.folders + ['sequence'])[0])
        return
    out, sequence = (given.folders + ['out', 'sequence'][len(given.folders):])[:2]
    run = {'version': manifest['engineVersion'], 'scheme': manifest['scheme'], 'ranks': 1}
    if os.path.exists(os.path.join(out, 'run.json')):
        with open(os.path.join(out, 'run.json')) as file:
            run = json.load(file)
    source = 'PySPH %s, scheme %s, %d rank%s' % (run['version'], run['scheme'], run['ranks'], 's'*(run['ranks'] > 1))
    write(pysph_frames(out), manifest, source, sequence)


if __name__ == '__main__':
    main()
";
    }
}
