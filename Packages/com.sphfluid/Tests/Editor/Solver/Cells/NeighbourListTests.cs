using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Steps with a list of neighbours against steps that search twice.</summary>
    public sealed class NeighbourListTests
    {
        private const float Spacing = 0.05f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [TestCase(1, FluidAxes.None)]
        [TestCase(31, FluidAxes.None)]
        [TestCase(33, FluidAxes.X)]
        [TestCase(257, FluidAxes.All)]
        [TestCase(1009, FluidAxes.None)]
        public void TheMotionIsTheSame(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.3f);
            settings.Boundaries.Periodic = periodic;
            FluidParticle[] start = ParticleSets.Random(count, 0.9f * Domain, 0.1f, 6);

            AssertSame(Run(settings, true, start, 3), Run(settings, false, start, 3));
        }

        // 200 particles within R of each other; a list holds 100 at most.
        [Test]
        public void WhoHasMoreNeighboursThanTheListHoldsSearchesAgain()
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.3f);
            settings.TimeStep *= 1e-2f;
            FluidParticle[] start = ParticleSets.Random(200, Vector3.one * (0.9f * Spacing), 0.1f, 7);

            AssertSame(Run(settings, true, start, 1), Run(settings, false, start, 1));
        }

        [Test]
        public void NeighboursBehindASheetAreNotListed()
        {
            FluidParticle[] Run(bool list)
            {
                FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.3f);
                settings = With(settings, list);
                using (var rig = new BodyRig(settings))
                {
                    rig.Add(new[] { new Vector3(0.01f, -0.5f, -0.5f), new Vector3(0.01f, 1.5f, -0.5f), new Vector3(0.01f, -0.5f, 1.5f) });
                    rig.Start(ParticleSets.Lattice(new Vector3Int(7, 6, 5), Spacing, 0.1f * Spacing, 1));
                    rig.Frame(3);
                    return rig.Particles();
                }
            }
            AssertSame(Run(true), Run(false));
        }

        [TestCase(2f, 52)]
        [TestCase(2.25f, 72)]
        [TestCase(2.5f, 100)]
        public void TheListHoldsHalfAsManyAgain(float ratio, int length)
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.3f);
            settings.SupportRadius = ratio * Spacing;

            Assert.That(NeighbourList.LengthFor(settings), Is.EqualTo(length));
            Assert.That(NeighbourList.Fits(1000, length), Is.True);
            Assert.That(NeighbourList.Fits(int.MaxValue, length), Is.False);
        }

        [Test]
        public void AListThatIsSwitchedOffIsFreed()
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.3f);
            using (var rig = new StandardRig(settings, ParticleSets.Random(65, Domain, 1f, 8)))
            {
                rig.Steps(1);
                long with = rig.Solver.GpuBytes;
                settings = settings.WithOwn((ref StandardSettings own) => own.NeighbourList = false);
                rig.Solver.ApplySettings(settings);
                rig.Steps(1);

                // 96 particles' columns; the numbers of each stay behind them.
                Assert.That(with - rig.Solver.GpuBytes, Is.EqualTo(4 * 96 * (NeighbourList.LengthFor(settings) / 2 + 1)));
            }
        }

        // Every step sorts anew.
        private static FluidSolverSettings With(in FluidSolverSettings settings, bool list) =>
            settings.WithOwn((ref StandardSettings own) => (own.NeighbourList, own.StepsPerSort) = (list, 1));

        private static FluidParticle[] Run(FluidSolverSettings settings, bool list, FluidParticle[] start, int steps)
        {
            settings = With(settings, list);
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps(steps);
                return rig.Particles();
            }
        }

        private static void AssertSame(FluidParticle[] actual, FluidParticle[] expected)
        {
            float fastest = expected.Max(p => p.VelT0.magnitude);
            for (int i = 0; i < expected.Length; i++)
            {
                Assert.That(actual[i].Id, Is.EqualTo(expected[i].Id));
                Assert.That((actual[i].VelT0 - expected[i].VelT0).magnitude, Is.LessThanOrEqualTo(1e-4f * fastest), $"particle {i}");
            }
        }
    }
}
