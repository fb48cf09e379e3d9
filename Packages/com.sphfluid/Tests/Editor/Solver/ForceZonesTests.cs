using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>
    /// Force zones on particles in free flight, too far apart to feel each other, against the same steps in double precision.
    /// </summary>
    public sealed class ForceZonesTests
    {
        private const float Spacing = 0.02f, TimeStep = 1e-4f;
        private const int Steps = 40;

        private static readonly Vector3 Domain = new Vector3(1.2f, 1f, 1.1f);

        [Test]
        public void AZoneActsAsTheFormulaSays([Values("uniform", "point", "vortex", "wind", "eddies", "all")] string kind,
            [Values("box", "sphere", "capsule")] string shape)
        {
            ForceZone zone = Zone(kind, shape);
            FluidParticle[] start = Start(), end = Run(start, zone), again = Run(start, zone);
            Assert.That(end, Is.EqualTo(again), "to the last bit");
            int moved = 0, still = 0;
            for (int i = 0; i < start.Length; i++)
            {
                (double[] position, double[] velocity) = Reference(start[i], zone, shape, EdgeOf());
                for (int axis = 0; axis < 3; axis++)
                {
                    Assert.That(end[i].Position[axis], Is.EqualTo(position[axis]).Within(2e-6), $"particle {i}");
                }
                double change = Enumerable.Range(0, 3).Sum(a => Math.Abs(velocity[a] - start[i].VelT0[a]));
                if (change > 1e-3) moved++;
                if (change == 0.0) still++;
            }
            Assert.That(moved, Is.GreaterThan(10));
            Assert.That(still, Is.GreaterThan(10));
        }

        [Test]
        public void WithoutZonesNothingChangesAndMoreThanTheMostAreRefused()
        {
            FluidParticle[] start = Start();
            Assert.That(Run(start), Is.EqualTo(Run(start, null)));
            using (var zones = new ForceZones())
            {
                Assert.That(zones.SetZones(new ForceZone[0]), Is.False);
                Assert.That(zones.GpuBytes, Is.Zero);
                Assert.That(() => zones.SetZones(new ForceZone[ForceZone.Most + 1]), Throws.ArgumentException);
                Assert.That(zones.SetZones(new[] { Zone("wind", "box") }), Is.True);
                Assert.That(zones.SetZones(new[] { Zone("wind", "box") }), Is.False);
                Assert.That(zones.SetZones(new[] { Zone("point", "box") }), Is.True);
            }
        }

        [Test]
        public void ZonesAddUp()
        {
            FluidParticle[] start = Start();
            ForceZone uniform = Zone("uniform", "sphere"), vortex = Zone("vortex", "sphere"), both = uniform;
            both.Axis = vortex.Axis;
            FluidParticle[] apart = Run(start, uniform, vortex), joined = Run(start, both);
            for (int i = 0; i < start.Length; i++) Assert.That((apart[i].Position - joined[i].Position).magnitude, Is.LessThan(1e-6f));
        }

        [Test]
        public void ZonesActAlsoWithMeshesAndPeriodicAxes([Values] bool mesh, [Values(FluidAxes.None, FluidAxes.All)] FluidAxes periodic)
        {
            FluidParticle[] start = Start();
            ForceZone zone = Zone("all", "capsule");
            FluidParticle[] plain = Run(start, zone), end = Run(start, mesh, periodic, zone), free = Run(start, mesh, periodic);
            Assert.That(Enumerable.Range(0, start.Length).Max(i => (end[i].Position - plain[i].Position).magnitude), Is.LessThan(1e-6f));
            Assert.That(Enumerable.Range(0, start.Length).Max(i => (end[i].Position - free[i].Position).magnitude), Is.GreaterThan(1e-4f));
        }

        private static FluidSolverSettings Settings()
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Domain;
            input.Spacing = Spacing;
            input.LiquidHeight = 1f;
            input.LiquidDepth = 0.5f;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Gravity = Vector3.zero;
            settings.TimeStep = TimeStep;
            return settings;
        }

        private static double EdgeOf() => Settings().SupportRadius;

        // A lattice of 0.1 m, more than two support radii, of 7 x 5 x 7 and a velocity each.
        private static FluidParticle[] Start()
        {
            var random = new System.Random(3);
            var particles = new List<FluidParticle>();
            for (int x = -3; x <= 3; x++)
                for (int y = -2; y <= 2; y++)
                    for (int z = -3; z <= 3; z++)
                    {
                        var velocity = new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f,
                            (float)random.NextDouble() - 0.5f);
                        particles.Add(new FluidParticle(new Vector3(x, y, z) * 0.1f, velocity, (uint)particles.Count));
                    }
            return particles.ToArray();
        }

        private static ForceZone Zone(string kind, string shape)
        {
            bool all = kind == "all";
            var zone = new ForceZone();
            if (kind == "uniform" || all) zone.Uniform = new Vector4(20f, -70f, 30f, 0f);
            if (kind == "point" || all) zone.Centre.w = -60f;
            if (kind == "vortex" || all) zone.Axis = new Vector4(0.6f, 0f, 0.8f, 50f);
            if (kind == "wind" || all) zone.Wind = new Vector4(1f, 2f, -1.5f, 200f);
            if (kind == "eddies" || all) zone.Eddies = new Vector4(80f, 12f, 2.5f, 0f);
            zone.Core = CoreOf(shape);
            zone.Place(Centre, Turn);
            return zone;
        }

        private static readonly Vector3 Centre = new Vector3(0.03f, -0.02f, 0.05f);
        private static readonly Quaternion Turn = Quaternion.Euler(20f, 35f, -50f);

        private static Vector4 CoreOf(string shape) => shape == "box" ? new Vector4(0.2f, 0.25f, 0.18f, 0f)
            : shape == "sphere" ? new Vector4(0f, 0f, 0f, 0.24f) : new Vector4(0f, 0.15f, 0f, 0.2f);

        private static FluidParticle[] Run(FluidParticle[] start, params ForceZone[] given) => Run(start, false, FluidAxes.None, given);

        // The mesh is in a corner, away from the particles.
        private static FluidParticle[] Run(FluidParticle[] start, bool mesh, FluidAxes periodic, params ForceZone[] given)
        {
            GpuTest.Require();
            FluidSolverSettings settings = Settings();
            settings.Boundaries.Periodic = periodic;
            using (var obstacles = new FluidObstacles(settings))
            using (var zones = new ForceZones())
            using (var solver = new FluidSolver(settings, TestShaders.PackageSet, start))
            using (var cmd = new CommandBuffer())
            {
                if (given != null)
                {
                    zones.SetZones(given);
                    solver.SetZones(zones);
                }
                if (mesh)
                {
                    obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(0.04f * Vector3.one)),
                        Matrix4x4.Translate(new Vector3(0.5f, 0.4f, 0.45f)));
                    obstacles.Update(Matrix4x4.identity);
                    solver.SetObstacles(obstacles);
                }
                solver.RecordSteps(cmd, Steps, TimeStep);
                solver.RecordNeighbourSetup(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
                var read = new FluidParticle[solver.ParticleCount];
                solver.Particles.GetData(read);
                return read.OrderBy(p => p.Id).ToArray();
            }
        }

        // The shapes by their distances, not by the shader's rounded box.
        private static double Depth(double[] position, string shape)
        {
            var offset = new Vector3((float)(position[0] - Centre.x), (float)(position[1] - Centre.y), (float)(position[2] - Centre.z));
            Vector3 p = Quaternion.Inverse(Turn) * offset;
            Vector4 core = CoreOf(shape);
            if (shape == "sphere") return core.w - p.magnitude;
            if (shape == "capsule") return core.w - (p - new Vector3(0f, Mathf.Clamp(p.y, -core.y, core.y), 0f)).magnitude;
            return Math.Min(core.x - Math.Abs(p.x), Math.Min(core.y - Math.Abs(p.y), core.z - Math.Abs(p.z)));
        }

        private static (double[], double[]) Reference(in FluidParticle start, in ForceZone zone, string shape, double edge)
        {
            var x = new double[] { start.Position.x, start.Position.y, start.Position.z };
            var v = new double[] { start.VelT0.x, start.VelT0.y, start.VelT0.z };
            for (int step = 0; step < Steps; step++)
            {
                double kick = step == 0 ? 0.5 * TimeStep : TimeStep;
                double t = Math.Min(1.0, Math.Max(0.0, Depth(x, shape) / edge));
                double weight = t * t * (3.0 - 2.0 * t), rate = weight * zone.Wind.w;
                double[] d = { x[0] - Centre.x, x[1] - Centre.y, x[2] - Centre.z };
                double far = Math.Max(edge, Math.Sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
                var around = new double[3];
                for (int a = 0; a < 3; a++)
                {
                    int b = (a + 1) % 3, c = (a + 2) % 3;
                    around[a] = zone.Axis[b] * d[c] - zone.Axis[c] * d[b];
                }
                double k = zone.Eddies.y, turn = zone.Eddies.z;
                double[] phases = { k * x[0] + turn, k * x[1] + 1.31 * turn, k * x[2] + 1.73 * turn };
                double ring = Math.Max(edge, Math.Sqrt(around[0] * around[0] + around[1] * around[1] + around[2] * around[2]));
                for (int a = 0; a < 3; a++)
                {
                    double force = weight * (zone.Uniform[a] - zone.Centre.w * d[a] / far + zone.Axis.w * around[a] / ring +
                        0.5 * zone.Eddies.x * (Math.Sin(phases[(a + 2) % 3]) + Math.Cos(phases[(a + 1) % 3])));
                    v[a] += kick * (force - rate / (1.0 + rate * kick) * (v[a] - zone.Wind[a]));
                }
                for (int a = 0; a < 3; a++) x[a] += TimeStep * v[a];
            }
            return (x, v);
        }
    }
}
