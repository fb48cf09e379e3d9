using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The iterations of an implicit viscosity against the solution by conjugate gradients in double precision.</summary>
    public sealed class DiffuseVelocitiesTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 2e-3f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void TheVelocitiesSolveTheViscousEquations([Values(1, 63, 64, 65, 257, 509)] int count,
            [Values(FluidAxes.None, FluidAxes.Y, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = Settings(periodic, 1f);
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles =
                    Fill(rig, count, listed, out Double3[] start, out Double3[] kicked, out ViscousReference reference);
                Double3[] exact = Solution(reference, kicked);
                Double3[] found = Diffuse(rig, reference, 60);
                Double3[] error = found.Zip(exact, (a, b) => a - b).ToArray();
                double scale = Math.Sqrt(ViscousReference.Product(exact, exact) / count);
                Assert.That(Math.Sqrt(ViscousReference.Product(error, error) / count), Is.LessThan(2e-5 * (scale + 1.0)));
            }
        }

        // The bound of theory, 1/T_K, for what the start is away from the solution.
        [TestCase(2)]
        [TestCase(5)]
        [TestCase(14)]
        [TestCase(31)]
        public void AFewIterationsLeaveWhatChebyshevsBoundLeaves(int iterations)
        {
            const int count = 509;
            FluidSolverSettings settings = Settings(FluidAxes.None, 0.5f);
            using (var rig = new StandardStateRig(settings, count))
            {
                Fill(rig, count, true, out Double3[] start, out Double3[] kicked, out ViscousReference reference);
                Double3[] exact = Solution(reference, kicked);
                Double3[] found = Diffuse(rig, reference, iterations);
                double before = Norm(start, exact), after = Norm(found, exact);
                double b = 1.0 + TimeStep * 1.001 * reference.Bound;
                double zero = 1.0 - Math.Cos(Math.PI / (2.0 * iterations));
                double a = Math.Max(0.1, (2.0 - b * zero) / (2.0 - zero)), s = (b + a) / (b - a);
                double left = 1.0 / Math.Cosh(iterations * Math.Log(s + Math.Sqrt(s * s - 1.0)));
                Assert.That(after, Is.LessThan(1.01 * left * before + 1e-5), $"{left:g3} are left by theory");
                Assert.That(after, Is.GreaterThan(0.0));
            }
        }

        // Without friction nothing takes momentum, whatever the iterations leave of the error, and whatever they begin with.
        [TestCase(4, 0.05f)]
        [TestCase(14, 0.5f)]
        [TestCase(40, 3f)]
        public void MomentumIsThatOfTheKickedVelocities(int iterations, float kinematic)
        {
            const int count = 1009;
            FluidSolverSettings settings = Settings(FluidAxes.None, kinematic);
            settings.Boundaries = default;
            using (var rig = new StandardStateRig(settings, count))
            {
                Fill(rig, count, true, out _, out Double3[] kicked, out ViscousReference reference);
                Double3[] found = Diffuse(rig, reference, iterations);
                Double3 lost = Sum(found) - Sum(kicked);
                double scale = kicked.Sum(v => v.Length);
                Assert.That(lost.Length / scale, Is.LessThan(2e-6));
                Assert.That(Norm(found, kicked), Is.GreaterThan(0.1), "the velocities have changed");
            }
        }

        // Where the velocities before the step already solve the equations, they stay.
        [Test]
        public void ASteadyFlowStays()
        {
            const int count = 257;
            FluidSolverSettings settings = Settings(FluidAxes.None, 2f);
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = Fill(rig, count, true, out Double3[] start, out _, out ViscousReference reference);
                Double3[] kicked = reference.Times(start).Select((v, i) => v - reference.WallDrive(i)).ToArray();
                StandardStateRig.Fill(rig.State.Buffers.NewVelocities,
                    kicked.Select(v => new Vector4((float)v.X, (float)v.Y, (float)v.Z, 0f)).ToArray());
                Assert.That(Norm(Diffuse(rig, reference, 5), start), Is.LessThan(2e-4));
            }
        }

        private static FluidSolverSettings Settings(FluidAxes periodic, float kinematic)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            settings.Viscosity = kinematic * settings.RestDensity;
            settings.Boundaries.Friction = periodic == FluidAxes.All ? 0f : 0.7f;
            if (periodic == FluidAxes.None) settings.Boundaries.LowX = new Vector3(0f, 2f, -1f);
            return settings;
        }

        private static FluidParticle[] Fill(StandardStateRig rig, int count, bool listed, out Double3[] start, out Double3[] kicked,
            out ViscousReference reference)
        {
            FluidSolverSettings settings = rig.State.Settings;
            Vector3 part = settings.Boundaries.Periodic == FluidAxes.All ? Domain : 0.9f * Domain;
            FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, part, 1f, 4));
            rig.FillList(particles, listed);
            rig.State.RequireViscous();
            var random = new System.Random(7);
            Vector3[] changed = particles.Select(p => p.VelT0 + ParticleSets.RandomVector(random) + Vector3.up).ToArray();
            StandardStateRig.Fill(rig.State.Buffers.NewVelocities, changed.Select(v => StandardStateRig.WithW(v, 0f)).ToArray());
            reference = new ViscousReference(settings, particles, TimeStep);
            start = particles.Select(p => (Double3)p.VelT0).ToArray();
            kicked = changed.Select(v => (Double3)v).ToArray();
            return particles;
        }

        private static Double3[] Solution(ViscousReference reference, Double3[] kicked) =>
            reference.Solve(kicked.Select((v, i) => v + reference.WallDrive(i)).ToArray());

        private static Double3[] Diffuse(StandardStateRig rig, ViscousReference reference, int iterations)
        {
            uint bound = StandardStateRig.ToBits((float)(1.001 * reference.Bound));
            rig.State.Viscous.Spectrum.SetData(new[] { bound, bound });
            var pass = new DiffuseVelocitiesPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State, new FluidStep(TimeStep, TimeStep, false), iterations));
            return GpuTest.Read<Vector4>(rig.State.Viscous.Diffused, rig.State.ParticleCount).Select(v => (Double3)(Vector3)v).ToArray();
        }

        private static Double3 Sum(Double3[] v) => v.Aggregate(Double3.Zero, (a, b) => a + b);

        private static double Norm(Double3[] a, Double3[] b)
        {
            Double3[] d = a.Zip(b, (x, y) => x - y).ToArray();
            return Math.Sqrt(ViscousReference.Product(d, d) / d.Length);
        }
    }
}
