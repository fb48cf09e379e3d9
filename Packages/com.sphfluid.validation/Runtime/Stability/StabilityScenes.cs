using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The small scenes of the maps: 200 to 600 particles, more where a wide support needs a larger periodic box.</summary>
    internal static class StabilityScenes
    {
        private const double Gravity = 9.81;
        private const double Jitter = 0.01; // standard deviation over dx
        private const double Dx = StabilityConstants.Spacing;

        // A box at rest: what it does to itself is compared with a flow at this part of c_eff, that of 1 % compression.
        private const double BoxMach = 0.1;

        /// <summary>
        /// M1: 6 × 10 × 6 particles or more on the floor, periodic across, compressed as they rest: x = dt·c/R, y = c/√(gH).
        /// </summary>
        public static StabilityScenario Column(StabilityRun run)
        {
            const int layers = 10;
            StabilityTheory theory = StabilityTheory.Of(run.Method);
            int across = PeriodicSide(theory.SupportRatio);
            double depth = layers * Dx, fall = Math.Sqrt(2.0 * Gravity * depth), sound = run.Y * Math.Sqrt(Gravity * depth);
            var domain = new Vector3((float)(across * Dx), (float)(depth + 6.0 * Dx), (float)(across * Dx));
            FluidSolverSettings settings = new StabilityConstants
            {
                Method = run.Method, DomainSize = domain, Support = theory.SupportRatio, Sound = sound, Viscosity = double.NaN,
                Clamps = run.Clamps,
                TimeStep = run.X * theory.SupportRatio * Dx / sound, Speed = fall, Gravity = new Vector3(0f, -(float)Gravity, 0f),
                Periodic = FluidAxes.X | FluidAxes.Z,
            }.Settings();
            double m = Math.Pow(run.Y * theory.WaveSpeedRatio, 2.0); // c_eff² = m g H
            List<Vector3> positions =
                CaseLattice.Box(new Vector3Int(across, layers, across), Dx, new Vector3(-0.5f * domain.x, 0f, -0.5f * domain.z));
            for (int i = 0; i < positions.Count; i++)
            {
                positions[i] = new Vector3(positions[i].x, (float)WallCaseSetup.Settled(positions[i].y, depth, m) - 0.5f * domain.y,
                    positions[i].z);
            }
            return Scene(settings, Jittered(positions, run, domain), 20.0 * Math.Sqrt(depth / Gravity), new StabilityScenario
            {
                ReferenceSpeed = fall, RestSpeed = 0.05 * Math.Sqrt(Gravity * depth), Depth = depth,
            });
        }

        /// <summary>M2: a periodic box of liquid at rest: x = ν·dt/R², y = dt·c/R.</summary>
        public static StabilityScenario ViscousBox(StabilityRun run)
        {
            const double sound = 10.0;
            double kappa = StabilityTheory.Of(run.Method).SupportRatio, radius = kappa * Dx, step = run.Y * radius / sound;
            return Box(run, kappa, sound, step, run.X * radius * radius / step, 0.0);
        }

        /// <summary>
        /// M4: a periodic box of liquid under pressure or suction: x = P/(ρc²), y = κ; half of the border's step, twice the viscosity of
        /// the rules.
        /// </summary>
        public static StabilityScenario PressedBox(StabilityRun run)
        {
            const double sound = 10.0;
            StabilityTheory theory = StabilityTheory.Of(run.Method);
            StabilityScenario scene = Box(run, run.Y, sound, 0.5 * theory.AcousticBorder * run.Y * Dx / sound, double.NaN, run.X);
            scene.Setup.Settings.Viscosity *= 2f;
            return scene;
        }

        /// <summary>
        /// M3: two cubes of 6³ particles collide at ±v without gravity in a periodic box, so that nothing takes momentum: x = dt·v/dx, y =
        /// c/v.
        /// </summary>
        public static StabilityScenario Collision(StabilityRun run)
        {
            const int side = 6;
            const double speed = 1.0;
            double sound = run.Y * speed, length = side * Dx;
            var domain = new Vector3((float)(8.0 * length), (float)(8.0 * length), (float)(8.0 * length));
            FluidSolverSettings settings = new StabilityConstants
            {
                Method = run.Method, DomainSize = domain, Support = StabilityTheory.Of(run.Method).SupportRatio, Sound = sound,
                Viscosity = double.NaN, Clamps = run.Clamps,
                TimeStep = run.X * Dx / speed, Speed = speed, Periodic = FluidAxes.All,
            }.Settings();
            float half = (float)(0.5 * length), gap = (float)Dx;
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(side, side, side), Dx, new Vector3(gap, -half, -half));
            positions.AddRange(CaseLattice.Box(new Vector3Int(side, side, side), Dx, new Vector3(-gap - 2f * half, -half, -half)));
            CaseLattice.Jitter(positions, Jitter * Dx, run.Seed, 0.4999f * domain);
            FluidParticle[] particles = CaseLattice.Particles(positions, p => new Vector3(p.x > 0f ? -(float)speed : (float)speed, 0f, 0f));
            return Scene(settings, particles, 3.0 * length / speed, new StabilityScenario { ReferenceSpeed = speed, Closed = true });
        }

        /// <summary>
        /// M6: two drops of 4 particles in radius collide at ±v from beyond each other's reach, in a periodic box: x = dt·v/dx, y = c/v.
        /// </summary>
        public static StabilityScenario Drops(StabilityRun run)
        {
            const double speed = 1.0, radius = 4.0 * Dx, apart = 8.0 * Dx;
            double sound = run.Y * speed;
            Vector3 domain = Vector3.one * (float)(16.0 * radius), offset = (float)(radius + 0.5 * apart) * Vector3.right;
            FluidSolverSettings settings = new StabilityConstants
            {
                Method = run.Method, DomainSize = domain, Support = StabilityTheory.Of(run.Method).SupportRatio, Sound = sound,
                Viscosity = double.NaN, Clamps = run.Clamps,
                TimeStep = run.X * Dx / speed, Speed = speed, Periodic = FluidAxes.All,
            }.Settings();
            List<Vector3> ball = CaseLattice.Ball(radius, Dx);
            List<Vector3> positions = ball.Select(p => p - offset).Concat(ball.Select(p => p + offset)).ToList();
            CaseLattice.Jitter(positions, Jitter * Dx, run.Seed, 0.4999f * domain);
            FluidParticle[] particles = CaseLattice.Particles(positions, p => new Vector3(p.x > 0f ? -(float)speed : (float)speed, 0f, 0f));
            return Scene(settings, particles, (0.5 * apart + 4.0 * radius) / speed,
                new StabilityScenario { ReferenceSpeed = speed, Closed = true });
        }

        /// <summary>
        /// M5: particles out of each other's reach fall with v onto a closed slab: x = v·dt/dx, y = its thickness over dx.
        /// </summary>
        public static StabilityScenario Spray(StabilityRun run)
        {
            const int side = 8, layers = 4;
            const double speed = 1.0, apart = 2.5 * Dx;
            double width = (side + 1) * apart, height = layers * apart, below = 8.0 * Dx;
            var domain = new Vector3((float)width, (float)(2.0 * Math.Max(below, height + 2.0 * Dx)), (float)width);
            FluidSolverSettings settings = new StabilityConstants
            {
                Method = run.Method, DomainSize = domain, Support = StabilityTheory.Of(run.Method).SupportRatio, Sound = speed,
                Viscosity = double.NaN, Clamps = run.Clamps,
                TimeStep = run.X * Dx / speed, Speed = speed,
            }.Settings();
            var positions = new List<Vector3>();
            var random = new System.Random(run.Seed);
            for (int layer = 0; layer < layers; layer++)
            {
                // Each layer falls into the gaps of the others, and each particle reaches the slab at another part of a step.
                double shiftX = 0.5 * apart * (layer & 1), shiftZ = 0.5 * apart * (layer >> 1);
                for (int i = 0; i < side * side; i++)
                {
                    positions.Add(new Vector3((float)((i % side + 0.75) * apart + shiftX - 0.5 * width),
                        (float)(Dx + layer * apart + 0.2 * apart * random.NextDouble()),
                        (float)((i / side + 0.75) * apart + shiftZ - 0.5 * width)));
                }
            }
            FluidParticle[] particles = CaseLattice.Particles(positions, p => new Vector3(0f, -(float)speed, 0f));
            StabilityScenario scene =
                Scene(settings, particles, (height + 6.0 * Dx) / speed, new StabilityScenario { ReferenceSpeed = speed, WallTop = 0.0 });
            double thickness = run.Y * Dx;
            scene.Setup.Obstacles =
                new[] { Slab(new Vector3(0f, (float)(-0.5 * thickness), 0f), new Vector3(2f * domain.x, (float)thickness, 2f * domain.z)) };
            return scene;
        }

        /// <summary>A periodic box of liquid at rest.</summary>
        public static StabilityScenario Box(StabilityRun run, double kappa, double sound, double timeStep, double viscosity,
            double pressure)
        {
            int side = PeriodicSide(kappa);
            double mach = BoxMach * sound * StabilityTheory.Of(run.Method).WaveSpeedRatio;
            var domain = Vector3.one * (float)(side * Dx);
            FluidSolverSettings settings = new StabilityConstants
            {
                Method = run.Method, DomainSize = domain, Support = kappa, Sound = sound, Viscosity = viscosity, Clamps = run.Clamps,
                TimeStep = timeStep, Speed = mach, Periodic = FluidAxes.All, Suction = true,
            }.Settings();
            settings.ParticleMass *= (float)(1.0 + pressure); // P = c_eff² (ρ − ρ0)
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(side, side, side), Dx, -0.5f * domain);
            double mass = settings.ParticleMass * positions.Count;
            return Scene(settings, Jittered(positions, run, domain), 200.0 * kappa * Dx / sound, new StabilityScenario
            {
                ReferenceSpeed = mach, RestSpeed = 0.05 * mach, EnergyScale = 0.5 * mass * mach * mach, Closed = true,
            });
        }

        // Three cells of R.
        private static int PeriodicSide(double kappa) => Math.Max(6, (int)Math.Ceiling(3.0 * kappa - 1e-6));

        private static StabilityScenario Scene(in FluidSolverSettings settings, FluidParticle[] particles, double duration,
            StabilityScenario expected)
        {
            expected.Setup = new CaseSetup { Settings = settings, Particles = particles, Duration = duration };
            return expected;
        }

        private static FluidParticle[] Jittered(List<Vector3> positions, StabilityRun run, Vector3 domain)
        {
            CaseLattice.Jitter(positions, Jitter * Dx, run.Seed, 0.4999f * domain);
            return CaseLattice.Particles(positions);
        }

        private static Vector3[] Slab(Vector3 centre, Vector3 size)
        {
            TriangleMesh mesh = TriangleMesh.Box(Matrix4x4.TRS(centre, Quaternion.identity, size));
            var corners = new List<Vector3>();
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                corners.AddRange(new[] { a, b, c });
            }
            return corners.ToArray();
        }
    }
}
