using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the equations conserve, and the manners of the CPU solver.</summary>
    public sealed class CpuFluidSolverTests
    {
        private static readonly Vector3 Domain = new Vector3(0.4f, 0.4f, 0.4f);

        [Test]
        public void ClosedSystemKeepsItsMomentum()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            settings.DomainSize = Vector3.one;
            settings.Gravity = Vector3.zero;
            // Slow enough to come to no wall in 1,000 steps.
            settings = settings.WithOwn((ref ThesisSettings own) => own.Stiffness *= 0.01f);
            FluidParticle[] initial = ParticleSets.Lattice(new Vector3Int(5, 5, 5), 0.018f, 0.002f, 5);
            using (var solver = new CpuFluidSolver(settings, initial))
            {
                // The momenta cancel, so the drift is seen against the sum of their magnitudes.
                double largest = 0.0;
                for (int i = 0; i < 10; i++)
                {
                    solver.Step(100);
                    largest = Math.Max(largest, solver.Particles.ToArray().Sum(p => math.length(p.VelT0)));
                }

                double3 sum = double3.zero;
                foreach (CpuFluidParticle particle in solver.Particles.ToArray())
                {
                    sum += particle.VelT0;
                    Assert.That(math.all(math.abs(particle.Position) < new double3(0.48, 0.48, 0.48)), "no wall took part");
                }

                Assert.That(largest, Is.GreaterThan(0.1), "the particles moved");
                Assert.That(solver.Counters.AccelerationLimitHits, Is.Zero);
                TestContext.WriteLine($"drift {math.length(sum) / largest:E1} of {largest:F2} m/s");
                Assert.That(math.length(sum) / largest, Is.LessThan(1e-12), "1e-5 is asked");
            }
        }

        [TestCase(CpuFluidPrecision.Double)]
        [TestCase(CpuFluidPrecision.Single)]
        public void FreeFallMovesNothingAgainstAnother(CpuFluidPrecision precision)
        {
            const float spacing = 0.02f;
            FluidSolverSettings settings = TestSettings.ByRule(new Vector3(0.4f, 1.2f, 0.4f), spacing);
            FluidParticle[] initial = ParticleSets.Lattice(new Vector3Int(5, 5, 5), spacing, 0f, 1);
            for (int i = 0; i < initial.Length; i++) initial[i].Position.y += 0.4f;

            using (var solver = new CpuFluidSolver(settings, initial, precision))
            {
                int steps = (int)(0.35 / settings.TimeStep);
                solver.Step(steps);
                CpuFluidParticle[] particles = solver.Particles.ToArray();
                double fall = 0.5 * 9.81f * Math.Pow(steps * (double)settings.TimeStep, 2);
                double worst = 0.0;
                foreach (CpuFluidParticle particle in particles)
                {
                    double3 expected = CpuFluidParticle.Double(initial[particle.Id].Position) - new double3(0.0, fall, 0.0);
                    worst = Math.Max(worst, math.length(particle.Position - expected));
                }

                Assert.That(fall, Is.GreaterThan(0.5));
                Assert.That(worst, Is.LessThan(1e-4 * spacing));
            }
        }

        [Test]
        public void TwoRunsAreBitwiseEqual()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            FluidParticle[] initial = ParticleSets.Random(500, 0.5f * Domain, 2f, 3);
            CpuFluidParticle[][] ends = { Run(settings, initial, 20), Run(settings, initial, 20) };
            Assert.That(ends[0].Select(p => p.Id), Is.EqualTo(ends[1].Select(p => p.Id)));
            Assert.That(ends[0].Select(p => p.Position), Is.EqualTo(ends[1].Select(p => p.Position)));
            Assert.That(ends[0].Select(p => p.VelT0), Is.EqualTo(ends[1].Select(p => p.VelT0)));
        }

        [Test]
        public void StepsInOneOrManyCallsAreTheSame()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            FluidParticle[] initial = ParticleSets.Random(100, 0.3f * Domain, 2f, 4);
            using (var solver = new CpuFluidSolver(settings, initial))
            {
                CpuScenes.AddMeshes(solver, CpuScenes.Sheet());
                solver.Step(3);
                solver.UpdateDensity();
                solver.Step(0);
                solver.Step(2);
                Assert.That(solver.StepCount, Is.EqualTo(5));
                Assert.That(solver.SimulatedTime, Is.EqualTo(5.0 * settings.TimeStep).Within(1e-12));
                Assert.That(solver.Particles.ToArray().Select(p => p.Position),
                    Is.EqualTo(Run(settings, initial, 5).Select(p => p.Position)));
            }
        }

        [Test]
        public void BadInputIsNamed()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.02f);
            var particle = new FluidParticle(Vector3.zero, Vector3.zero, 0);
            Assert.That(() => new CpuFluidSolver(settings, new FluidParticle[0]), Throws.ArgumentException);
            var outside = new FluidParticle(Vector3.one, Vector3.zero, 0);
            Assert.That(() => new CpuFluidSolver(settings, new[] { outside }), Throws.ArgumentException.With.Message.Contains("outside"));
            var solver = new CpuFluidSolver(settings, new[] { particle });
            Assert.That(() => solver.Step(-1), Throws.TypeOf<ArgumentOutOfRangeException>());
            Assert.That(() => solver.AddMesh(new Vector3[4], false), Throws.ArgumentException.With.Message.Contains("4 corners"));
            solver.Dispose();
            solver.Dispose();
            Assert.That(() => solver.Step(1), Throws.TypeOf<ObjectDisposedException>());
            Assert.That(() => solver.Density, Throws.TypeOf<ObjectDisposedException>());
        }

        private static CpuFluidParticle[] Run(in FluidSolverSettings settings, FluidParticle[] initial, int steps)
        {
            using (var solver = new CpuFluidSolver(settings, initial))
            {
                CpuScenes.AddMeshes(solver, CpuScenes.Sheet());
                solver.Step(steps);
                return solver.Particles.ToArray();
            }
        }
    }
}
