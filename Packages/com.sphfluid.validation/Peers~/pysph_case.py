"""Runs a validation case with PySPH.

    python3 pysph_case.py FOLDER      reads case.json and start.npy, writes sample-*.npy, samples.csv and run.csv there
    python3 pysph_case.py --version   says which PySPH this is

./run peers calls it. Particles, box and forces are the case's; schemes, kernels, integrators and wall particles are PySPH's, with the constants that
its authors have in their example of that kind of flow. Lengths are in metres from the middle of the box, all else is SI too.
"""
import csv
import json
import os
import sys
import time
from itertools import product

try:
    import numpy as np
    import pysph
    from compyle.config import get_config
    from pysph.base import kernels
    from pysph.base.nnps import DomainManager
    from pysph.base.utils import get_particle_array, get_particle_array_wcsph
    from pysph.solver.application import Application
    from pysph.solver.solver import Solver
    from pysph.sph.basic_equations import XSPHCorrection
    from pysph.sph.equation import Equation, Group
    from pysph.sph.integrator import EPECIntegrator, PECIntegrator
    from pysph.sph.integrator_step import WCSPHStep
    from pysph.sph.scheme import TVFScheme, WCSPHScheme
    from pysph.sph.wc import transport_velocity as tvf
    from pysph.sph.wc.basic import TaitEOS
    from pysph.tools.interpolator import Interpolator
except ImportError as error:
    sys.exit(f"{sys.executable} has no PySPH ({error}).")

COLUMNS = ('x', 'y', 'z', 'u', 'v', 'w', 'rho', 'p')
PROBES_PER_SAMPLE = 10


class CentralForce(Equation):
    """The acceleration -k x, which PySPH has no equation for."""

    def __init__(self, dest, sources, kx, ky, kz):
        self.kx = kx
        self.ky = ky
        self.kz = kz
        super().__init__(dest, sources)

    def loop(self, d_idx, d_x, d_y, d_z, d_au, d_av, d_aw):
        d_au[d_idx] -= self.kx * d_x[d_idx]
        d_av[d_idx] -= self.ky * d_y[d_idx]
        d_aw[d_idx] -= self.kz * d_z[d_idx]


class Case(Application):
    """What all cases share: particles, walls, and states at the times of the samples."""

    kernel = kernels.WendlandQuintic
    integrator = PECIntegrator
    hdx = 1.3
    wall_layers = 4

    def __init__(self, folder, case):
        self.folder, self.case = folder, case
        self.dx, self.rho0, self.c0, self.speed = case['spacing'], case['restDensity'], case['soundSpeed'], case['speed']
        self.h0 = self.hdx * self.dx
        self.gravity = dict(zip(('gx', 'gy', 'gz'), case['gravity']))
        self.half = 0.5 * np.array(case['domainSize'])
        self.obstacles = [lattice(o['low'], o['high'], self.dx) for o in case['obstacles']]
        self.solids = (['boundary'] if case['walls'] else []) + (['obstacle'] if self.obstacles else [])
        self.samples, self.used, self.due, self.paused = [], [], 0.0, 0.0
        self.probe, self.probed, self.probe_due, self.pressures = None, [], 0.0, []
        super().__init__(fname='case', output_dir=os.path.join(folder, 'pysph'))

    def create_domain(self):
        periodic = self.case['periodic']
        if not any(periodic):
            return None
        limits = {}
        for axis, name in enumerate('xyz'):
            limits[f'{name}min'], limits[f'{name}max'] = -self.half[axis], self.half[axis]
            limits[f'periodic_in_{name}'] = bool(periodic[axis])
        return DomainManager(**limits)

    def create_particles(self):
        start = np.load(os.path.join(self.folder, 'start.npy')).astype(float)
        fluid = self.array('fluid', start[:, :3])
        for column, name in enumerate(COLUMNS[3:7], 3):
            getattr(fluid, name)[:] = start[:, column]
        arrays = [fluid]
        if 'boundary' in self.solids:
            places, velocities = walls(self.case, self.wall_layers)
            boundary = self.array('boundary', places)
            boundary.u[:], boundary.v[:], boundary.w[:] = velocities.T
            arrays.append(boundary)
        if self.obstacles:
            arrays.append(self.array('obstacle', np.concatenate(self.obstacles)))
        self.set_up(arrays)
        for array in arrays:
            array.gid[:] = np.arange(len(array.x))
        self.counts = {a.name: len(a.x) for a in arrays}
        return arrays

    def array(self, name, places):
        x, y, z = places.T
        return self.new_array(name=name, x=x.copy(), y=y.copy(), z=z.copy(), m=self.rho0 * self.dx**3, h=self.h0, rho=self.rho0)

    def new_array(self, **properties):
        return get_particle_array(**properties)

    def set_up(self, arrays):
        self.scheme.setup_properties(arrays)

    def pre_step(self, solver):
        """Keeps the state at the step nearest to a sample's time. The time that this takes is no part of the run's."""
        now = time.perf_counter()
        if self.due - solver.t < 0.5 * solver.dt:
            self.sample(solver, now)
        elif self.case['patches'] and self.probe_due - solver.t < 0.5 * solver.dt:
            self.read_patches(solver)
        self.paused += time.perf_counter() - now

    def sample(self, solver, now):
        if not self.samples:
            self.begun = now
        if self.case['patches']:
            self.read_patches(solver)
            self.pressures.append(np.mean(self.probed, axis=0) if self.samples else np.full(len(self.case['patches']), np.nan))
            self.probed = []
        fluid = solver.particles[0]
        state = np.array([fluid.get(name) for name in COLUMNS], dtype=np.float32).T
        state = state[np.argsort(fluid.get('gid'))]
        file = f'sample-{len(self.samples):05d}.npy'
        self.samples.append((solver.t, file, solver.count, now - self.begun - self.paused))
        self.used.append((now, busy_seconds(), own_seconds()))
        np.save(os.path.join(self.folder, file), state)
        interval = self.case['sampleInterval']
        self.due = interval * (np.floor((solver.t + 0.5 * solver.dt) / interval) + 1)
        if not np.isfinite(state).all():
            solver.set_final_time(solver.t)

    def read_patches(self, solver):
        """Pressures by Shepard's interpolation at points a spacing apart, as dam_break_3d.py reads its probes."""
        if self.probe is None:
            points = [patch_points(p, self.dx) for p in self.case['patches']]
            x, y, z = np.concatenate(points).T
            self.ends = np.cumsum([len(p) for p in points])[:-1]
            self.probe = Interpolator(solver.particles, x=x.copy(), y=y.copy(), z=z.copy(), method='shepard')
        else:
            self.probe.update()
        self.probed.append([part.mean() for part in np.split(self.probe.interpolate('p'), self.ends)])
        self.probe_due = solver.t + self.case['sampleInterval'] / PROBES_PER_SAMPLE


class FreeSurface(Case):
    """WCSPH by Monaghan's equations: Tait's equation of state, density by continuity, artificial viscosity, XSPH."""

    alpha, gamma = 0.1, 7.0
    hg_correction = update_h = False

    def create_scheme(self):
        return WCSPHScheme(['fluid'], self.solids, dim=3, rho0=self.rho0, c0=self.c0, h0=self.h0, hdx=self.hdx, alpha=self.alpha, beta=0.0,
                           gamma=self.gamma, hg_correction=self.hg_correction, update_h=self.update_h, **self.gravity)

    def configure_scheme(self):
        self.scheme.configure_solver(kernel=self.kernel(dim=3), integrator_cls=self.integrator, tf=self.case['duration'], dt=self.first_step(),
                                     adaptive_timestep=True, n_damp=50)

    def create_equations(self):
        equations = self.scheme.get_equations()
        if any(self.case['centralForce']):
            equations[-1].equations.append(CentralForce('fluid', None, *self.case['centralForce']))
        return equations


class Ellipsoid(FreeSurface):
    """Constants of pysph/examples/elliptical_drop.py."""

    kernel, integrator = kernels.Gaussian, EPECIntegrator

    def first_step(self):
        return 0.25 * self.h0 / (self.speed + self.c0)


class DamBreak(FreeSurface):
    """Constants of pysph/examples/dam_break_2d.py, whose column is twice as high as wide as well."""

    hg_correction = update_h = True

    def first_step(self):
        return 0.125 * self.h0 / self.c0


class Marin(FreeSurface):
    """Constants of pysph/examples/dam_break_3d.py, which is this tank."""

    integrator = EPECIntegrator
    alpha, hg_correction, wall_layers = 0.25, True, 2

    def first_step(self):
        return 0.25 * self.h0 / (1.1 * self.c0)


class Channel(Case):
    """Transport velocities (Adami, Hu and Adams 2013) with the constants of pysph/examples/poiseuille.py and couette.py."""

    kernel, hdx, wall_layers = kernels.QuinticSpline, 1.0, 5

    def create_scheme(self):
        p0 = self.c0**2 * self.rho0
        return TVFScheme(['fluid'], self.solids, dim=3, rho0=self.rho0, c0=self.c0, nu=self.case['viscosity'], p0=p0, pb=p0, h0=self.h0,
                         **self.gravity)

    def configure_scheme(self):
        force = np.linalg.norm(self.case['gravity'])
        step = min(0.25 * self.h0 / (self.c0 + self.speed), 0.125 * self.h0**2 / self.case['viscosity'],
                   0.25 * np.sqrt(self.h0 / force) if force > 0.0 else 1.0)
        self.scheme.configure_solver(kernel=self.kernel(dim=3), integrator_cls=self.integrator, tf=self.case['duration'], dt=step)

    def set_up(self, arrays):
        super().set_up(arrays)
        for array in arrays:
            array.V[:] = 1.0 / self.dx**3


class Column(Case):
    """Walls of Adami, Hu and Adams (2012) with the equations and constants of pysph/examples/hydrostatic_tank.py.

    There gravity comes on slowly, as its column does not start at rest; this one does.
    """

    kernel, hdx, wall_layers = kernels.QuinticSpline, 1.2, 6
    reynolds = 100.0

    def new_array(self, **properties):
        return get_particle_array_wcsph(**properties)

    def set_up(self, arrays):
        for array in arrays:
            array.rho0[:] = self.rho0
            array.add_property('V')
            array.V[:] = 1.0 / self.dx**3
            for name in ('wij',) if array.name == 'boundary' else ('auhat', 'avhat', 'awhat'):
                array.add_property(name)

    def create_solver(self):
        viscosity = self.speed * 1.0 / self.reynolds
        step = 0.75 * min(0.25 * self.h0 / (self.c0 + self.speed), 0.125 * self.h0**2 / viscosity,
                          0.25 * np.sqrt(self.h0 / np.linalg.norm(self.case['gravity'])))
        return Solver(kernel=self.kernel(dim=3), dim=3, integrator=self.integrator(fluid=WCSPHStep()), tf=self.case['duration'], dt=step)

    def create_equations(self):
        both = ['fluid', 'boundary']
        return [
            Group([tvf.VolumeFromMassDensity('fluid', None)], real=False),
            Group([TaitEOS('fluid', None, rho0=self.rho0, c0=self.c0, gamma=1.0)], real=False),
            Group([tvf.SolidWallPressureBC('boundary', ['fluid'], b=1.0, rho0=self.rho0, p0=self.c0**2 * self.rho0, **self.gravity)], real=False),
            Group([
                tvf.ContinuityEquation('fluid', both),
                tvf.MomentumEquationPressureGradient('fluid', both, pb=0.0, **self.gravity),
                tvf.MomentumEquationArtificialViscosity('fluid', both, alpha=0.24, c0=self.c0),
                XSPHCorrection('fluid', ['fluid'], eps=0.0),
            ]),
        ]


CASES = {'ellipsoid': Ellipsoid, 'dam-break': DamBreak, 'marin': Marin, 'poiseuille': Channel, 'couette': Channel, 'hydrostatic': Column}


def centres(low, high, dx):
    """Middles of equal cells about dx long."""
    count = max(1, round((high - low) / dx))
    return low + (np.arange(count) + 0.5) * (high - low) / count


def lattice(low, high, dx):
    return np.array(list(product(*(centres(l, h, dx) for l, h in zip(low, high)))))


def walls(case, layers):
    """Layers of particles outside of every face that is a wall, on the lattice that fills the box, with the velocities of the faces."""
    dx, axes = case['spacing'], []
    half = 0.5 * np.array(case['domainSize'])
    for axis in range(3):
        inside = centres(-half[axis], half[axis], dx)
        outside = half[axis] + (np.arange(layers) + 0.5) * dx
        axes.append(inside if case['periodic'][axis] else np.concatenate([-outside[::-1], inside, outside]))
    places = np.array(list(product(*axes)))
    places = places[(np.abs(places) > half).any(axis=1)]
    velocities = np.zeros_like(places)
    for axis, faces in enumerate(case['walls']):
        velocities[places[:, axis] < -half[axis]] += faces['low']
        velocities[places[:, axis] > half[axis]] += faces['high']
    return places, velocities


def patch_points(patch, dx):
    """Points a spacing apart on a rectangle."""
    along, up = np.array(patch['along']), np.array(patch['up'])
    a, b = (centres(-0.5 * length, 0.5 * length, dx) for length in patch['size'])
    return np.array([np.array(patch['centre']) + s * along + t * up for s, t in product(a, b)])


def busy_seconds():
    """Processor time of all programs on this machine; None where the system does not say."""
    try:
        with open('/proc/stat') as file:
            ticks = [int(word) for word in file.readline().split()[1:]]
    except OSError:
        return None
    return (sum(ticks[:3]) + sum(ticks[5:8])) / os.sysconf('SC_CLK_TCK')


def own_seconds():
    used = os.times()
    return used.user + used.system


def other_cores(used):
    """Cores that other programs kept busy, the median from sample to sample of (time, all programs' processor time, this one's)."""
    if len(used) < 2 or used[0][1] is None:
        return ''
    return max(0.0, np.median([(b[1] - a[1] - b[2] + a[2]) / (b[0] - a[0]) for a, b in zip(used, used[1:])]))


def write(path, names, *rows):
    with open(path, 'w', newline='') as file:
        writer = csv.writer(file, lineterminator='\n')
        writer.writerow(names)
        writer.writerows(rows)


def run(folder):
    with open(os.path.join(folder, 'case.json')) as file:
        case = json.load(file)
    begin = time.perf_counter()
    application = CASES[case['case']](folder, case)
    arguments = ['--openmp', '--quiet', '--disable-output', '--loglevel', 'none', '--max-steps', str(case['mostSteps'])]
    application.setup(arguments)
    if not get_config().use_openmp:
        raise SystemExit('PySPH would compute on one thread: its flag --openmp did nothing.')
    solver = application.solver
    set_up = time.perf_counter() - begin
    application.solve()
    if solver.t > application.samples[-1][0]:
        application.sample(solver, time.perf_counter())
    write(os.path.join(folder, 'samples.csv'), ('time_s', 'file', 'steps', 'wall_s'), *application.samples)
    if application.pressures:
        np.save(os.path.join(folder, 'pressures.npy'), np.array(application.pressures, dtype=np.float32))
    write(os.path.join(folder, 'run.csv'), *zip(*{
        'version': f'PySPH {pysph.__version__}',
        'support_over_dx': application.hdx * solver.kernel.radius_scale,
        'boundary_particles': sum(count for name, count in application.counts.items() if name != 'fluid'),
        'evaluations': 2 if application.integrator is EPECIntegrator else 1,
        'steps': solver.count,
        'end_s': solver.t,
        'set_up_s': set_up,
        'other_cores': other_cores(application.used),
    }.items()))


if __name__ == '__main__':
    if sys.argv[1:] == ['--version']:
        print(f'PySPH {pysph.__version__}')
    elif len(sys.argv) == 2:
        run(sys.argv[1])
    else:
        sys.exit(__doc__)
