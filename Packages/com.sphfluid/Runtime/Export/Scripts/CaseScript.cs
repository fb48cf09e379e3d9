namespace SphFluid
{
    /// <summary>case.py: the liquid of manifest.json as an application of PySPH. The same for every case.</summary>
    internal static class CaseScript
    {
        public const string Text = @"#!/usr/bin/env python3
'''The liquid of manifest.json as an application of PySPH.

    bash run.sh                processes by MPI (RANKS=8 bash run.sh), then sequence/ for Fluid Playback
    python3 case.py --openmp   one process with all cores; --help lists PySPH's options
    sbatch job.sbatch          the same on a cluster with Slurm

Exported by SPH Fluid for PySPH, Debian's packages python3-pysph python3-mpi4py python3-pyzoltan
openmpi-bin. The manifest holds versions, constants and what is not exported. SI units; the origin is the centre of the simulation's box, the
axes are its edges. The schemes are PySPH's own with the settings of its authors' dam breaks:
WCSPH as in pysph/examples/dam_break_3d.py, EDAC (--scheme edac) as in dam_break_2d.py.
Density, viscosity and speed of sound are the profile's.
'''
import json
import os
import resource
import time

import numpy as np
import pysph
from pysph.base.kernels import QuinticSpline, WendlandQuintic
from pysph.base.nnps import DomainManager
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.sph.integrator import EPECIntegrator
from pysph.sph.scheme import SchemeChooser, WCSPHScheme
from pysph.sph.wc.edac import EDACScheme

HERE = os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(HERE, 'manifest.json'), encoding='utf-8') as file:
    given = json.load(file)

dx = given['spacing']  # particle spacing [m]
hdx = 1.3  # smoothing length h over dx
rho0 = given['density']  # kg/m3
nu = given['viscosity']  # kinematic viscosity [m2/s]
c0 = given['soundSpeed']  # m/s
gravity = given['gravity']  # m/s2
seconds, frame_rate = given['seconds'], given['frameRate']  # s, 1/s
box = given['domainSize']  # m
periodic = [axis in given['periodicAxes'] for axis in 'XYZ']
solids = ['walls']*(given['wallParticles'] > 0)  # walls stay; bodyN goes through the poses of its path
solids += ['body%d' % number for number in range(len(given['bodies']))]


def read(name):
    return np.load(os.path.join(HERE, name))


def particles(name, table):
    columns = {column: table[column].astype(float) for column in 'xyzuvw'}
    return get_particle_array(name=name, m=rho0*dx**3, rho=rho0, h=hdx*dx, **columns)


def pose(path, t):
    '''Pivot and rotation matrix of a body at a time, linear between the poses.'''
    row = np.array([np.interp(t, path['t'], path[name]) for name in path.dtype.names[1:]])
    a, b, c, d = row[3:]/np.linalg.norm(row[3:])
    return row[:3, None], np.array([
        [1 - 2*(b*b + c*c), 2*(a*b - c*d), 2*(a*c + b*d)],
        [2*(a*b + c*d), 1 - 2*(a*a + c*c), 2*(b*c - a*d)],
        [2*(a*c - b*d), 2*(b*c + a*d), 1 - 2*(a*a + b*b)]])


class Case(Application):
    def initialize(self):
        self.paths = {name: read('body-%03d-path.npy' % int(name[4:])) for name in solids if name != 'walls'}

    def create_scheme(self):
        gx, gy, gz = gravity
        wcsph = WCSPHScheme(
            ['liquid'], solids, dim=3, rho0=rho0, c0=c0, h0=hdx*dx, hdx=hdx, gx=gx, gy=gy, gz=gz,
            nu=nu, alpha=0.25, beta=0.0, gamma=7.0, hg_correction=True, tensile_correction=False)
        edac = EDACScheme(
            ['liquid'], solids, dim=3, c0=c0, nu=nu, rho0=rho0, h=hdx*dx, pb=0.0, gx=gx, gy=gy,
            gz=gz, eps=0.0, clamp_p=True)
        return SchemeChooser(default=given['scheme'].lower(), wcsph=wcsph, edac=edac)

    def configure_scheme(self):
        h = hdx*dx
        viscous = 0.125*h*h/nu if nu > 0 else np.inf
        frames = np.arange(1, int(seconds*frame_rate + 0.5) + 1)/frame_rate
        solver = dict(tf=seconds, output_at_times=frames, pfreq=10**9)
        if self.options.scheme == 'edac':
            solver.update(kernel=QuinticSpline(dim=3), dt=min(0.125*h/c0, viscous))
        else:
            dt = 0.25*h/(1.1*c0)
            solver.update(kernel=WendlandQuintic(dim=3), integrator_cls=EPECIntegrator,
                          dt=min(dt, viscous), adaptive_timestep=dt < viscous, n_damp=50)
        self.scheme.configure_solver(**solver)

    def create_domain(self):
        if not any(periodic):
            return None
        if self.num_procs > 1:
            raise SystemExit('PySPH has no periodic box for several processes: python3 case.py --openmp')
        x, y, z = np.array(box)/2
        return DomainManager(
            xmin=-x, xmax=x, ymin=-y, ymax=y, zmin=-z, zmax=z, periodic_in_x=periodic[0],
            periodic_in_y=periodic[1], periodic_in_z=periodic[2])

    def create_particles(self):
        table = read('liquid.npy')
        liquid = particles('liquid', table)
        arrays = [liquid]
        for name in solids:
            start = read('walls.npy' if name == 'walls' else 'body-%03d.npy' % int(name[4:]))
            arrays.append(particles(name, start))
            if name in self.paths:
                for axis in 'xyz':  # place from the pivot
                    arrays[-1].add_property('b' + axis, data=start[axis].astype(float))
        self.scheme.setup_properties(arrays, clean=False)
        liquid.add_property('liquid_id', data=table['id'], type='unsigned int')
        liquid.add_output_arrays(['liquid_id'])
        for array in arrays:
            if array.name in self.paths:
                self.place(array, 0.0, 1e-6)
            array.set_lb_props(list(array.properties.keys()))  # all go along to another process
            if array is not liquid:
                array.set_output_arrays(['x', 'y', 'z', 'm', 'rho', 'p', 'h', 'gid', 'pid', 'tag'])
        return arrays

    def pre_step(self, solver):
        for body in self.particles:
            if body.name in self.paths:
                self.place(body, solver.t, solver.dt)

    def place(self, body, t, dt):
        '''A body where its path has it at a time, with the velocity that takes it on.'''
        from_pivot = np.array([body.bx, body.by, body.bz])
        (pivot, turn), (then, turned) = [pose(self.paths[body.name], moment) for moment in (t, t + dt)]
        now = pivot + turn @ from_pivot
        velocity = (then + turned @ from_pivot - now)/dt
        for number, axis in enumerate('xyz'):
            getattr(body, axis)[:] = now[number]
            getattr(body, 'uvw'[number])[:] = velocity[number]
            getattr(body, 'a' + axis)[:] = velocity[number]  # it moves within the step


def write_run(case, wall):
    '''run.json: what ran, for how long and in how much memory, of all processes together.'''
    used = resource.getrusage(resource.RUSAGE_SELF)
    used = [used.ru_maxrss/1024, used.ru_utime + used.ru_stime]
    if case.num_procs > 1:
        used = np.sum(case.comm.allgather(used), axis=0)
    if case.rank == 0:
        with open(os.path.join(case.output_dir, 'run.json'), 'w') as file:
            json.dump({'engine': 'PySPH', 'version': pysph.__version__, 'scheme': case.options.scheme.upper(),
                       'ranks': case.num_procs, 'openmp': case.options.openmp,
                       'steps': case.solver.count, 'time': case.solver.t,
                       'wall_s': round(wall, 2), 'cpu_s': round(used[1], 2),
                       'memory_mib': round(used[0], 1)}, file, indent=2)


if __name__ == '__main__':
    begun = time.time()
    app = Case(fname='case')
    app.run()
    write_run(app, time.time() - begun)
";
    }
}
