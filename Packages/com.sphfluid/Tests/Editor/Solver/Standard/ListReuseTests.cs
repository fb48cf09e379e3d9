using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Steps that keep the order of particles and their lists of neighbours, against steps that sort and search anew.</summary>
    public sealed class ListReuseTests
    {
        private const float Spacing = 0.05f;

        private static readonly Vector3 Domain = new Vector3(0.6f, 0.7f, 0.5f);

        private static FluidSolverSettings Water(int stepsPerSort, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = BodyRig.Water(Domain, Spacing, 0.3f);
            settings.Boundaries.Periodic = periodic;
            return settings.WithOwn((ref StandardSettings own) => own.StepsPerSort = stepsPerSort);
        }

        private static FluidParticle[] Run(FluidSolverSettings settings, FluidParticle[] start, int steps, out long setups)
        {
            using (var rig = new StandardRig(settings, start))
            {
                rig.Solver.FlowSpeed = 0f; // as many steps a list as the settings allow
                rig.Steps(steps);
                setups = rig.Solver.SetupCount;
                return rig.Particles().OrderBy(p => p.Id).ToArray();
            }
        }

        // Pairs that come within R between two sorts are found late: their weight is next to none.
        [TestCase(FluidAxes.None)]
        [TestCase(FluidAxes.All)]
        public void AListThatServesEightStepsMovesTheLiquidAsOneThatServesOne(FluidAxes periodic)
        {
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(9, 8, 7), Spacing, 0.1f * Spacing, 3);
            FluidParticle[] kept = Run(Water(8, periodic), start, 24, out long few),
                fresh = Run(Water(1, periodic), start, 24, out long many);
            Assert.That(few, Is.EqualTo(3 + 1), "and for those who read at the end");
            Assert.That(many, Is.EqualTo(24 + 1));
            float fastest = fresh.Max(p => p.VelT0.magnitude);
            double error = Math.Sqrt(kept.Zip(fresh, (a, b) => (double)(a.VelT0 - b.VelT0).sqrMagnitude).Average());
            Assert.That(fastest, Is.GreaterThan(0.05f), "it moves");
            Assert.That(error, Is.LessThan(0.01 * fastest));
        }

        // A ball's planes turn with the place they are seen from, and the particles behind it change: planes follow those that go far, cuts
        // every step.
        [Test]
        public void BesideACurvedBodyStepsThatKeepTheOrderMoveTheLiquidAsFreshOnes()
        {
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(11, 9, 9), Spacing, 0.1f * Spacing, 3)
                .Where(p => p.Position.magnitude > 0.12f).Select((p, i) => new FluidParticle(p.Position, p.VelT0, (uint)i)).ToArray();
            FluidParticle[] kept = AroundABall(8), fresh = AroundABall(1);
            float fastest = fresh.Max(p => p.VelT0.magnitude);
            FluidParticle[] near = fresh.Where(p => p.Position.magnitude < 0.1f + 2f * Spacing).ToArray();
            double error = Math.Sqrt(near.Average(p => (double)(p.VelT0 - kept[p.Id].VelT0).sqrMagnitude));
            Assert.That(near.Length, Is.GreaterThan(50));
            Assert.That(error, Is.LessThan(0.012 * fastest)); // 1.01 %: walls are known to second order for 0.07 R

            FluidParticle[] AroundABall(int stepsPerSort)
            {
                using (var rig = new BodyRig(Water(stepsPerSort)))
                {
                    rig.AddBall(0.1f, 10);
                    rig.Start(start);
                    rig.Solver.FlowSpeed = 0f;
                    rig.Frame(24);
                    return rig.Particles().OrderBy(p => p.Id).ToArray();
                }
            }
        }

        // Each pair is in both lists or in none, and is computed from the same places.
        [Test]
        public void MomentumStays([Values(63, 257, 1009)] int count)
        {
            FluidSolverSettings settings = Water(8, FluidAxes.All);
            settings.Gravity = Vector3.zero;
            FluidParticle[] start = ParticleSets.Random(count, Domain, 0.5f, 11);
            FluidParticle[] end = Run(settings, start, 8, out _);
            Double3 Sum(FluidParticle[] particles) => particles.Aggregate(default(Double3), (sum, p) => sum + p.VelT0);
            double fastest = end.Max(p => p.VelT0.magnitude);
            Assert.That(end.Zip(start, (a, b) => (a.VelT0 - b.VelT0).magnitude).Max(), Is.GreaterThan(0.01 * fastest),
                "they push each other");
            Assert.That((Sum(end) - Sum(start)).Length, Is.LessThan(2e-6 * count * fastest));
        }

        // A crowd that no list holds is shot into others whose lists hold all: who meets whom is decided alike by both.
        [Test]
        public void WhoIsInNoListPushesThoseWhoPushIt()
        {
            FluidSolverSettings settings = Water(8, FluidAxes.All);
            settings.Gravity = Vector3.zero;
            settings.TimeStep *= 0.1f;
            Vector3 speed = 0.05f * settings.SupportRadius / settings.TimeStep * Vector3.right;
            FluidParticle[] crowd = ParticleSets.Random(200, Vector3.one * (0.9f * Spacing), 0f, 7);
            FluidParticle[] start = crowd.Select(p => new FluidParticle(p.Position + 0.15f * Vector3.left, speed, p.Id))
                .Concat(ParticleSets.Lattice(new Vector3Int(4, 5, 5), Spacing, 0.1f * Spacing, 3)
                    .Select(p => new FluidParticle(p.Position + 0.05f * Vector3.right, Vector3.zero, p.Id + 200u))).ToArray();
            FluidParticle[] end = Run(settings, start, 8, out _);
            Double3 Change(System.Func<FluidParticle, bool> of) => end.Zip(start, (a, b) => (a, b)).Where(pair => of(pair.b))
                .Aggregate(default(Double3), (sum, pair) => sum + ((Double3)pair.a.VelT0 - pair.b.VelT0));
            double gained = Change(p => p.Id >= 200u).Length;
            Assert.That(gained, Is.GreaterThan(0.01 * speed.x), "the crowd pushes the others");
            Assert.That(Change(_ => true).Length, Is.LessThan(0.001 * gained));
        }

        [Test]
        public void EqualRunsAreEqualToTheLastBit()
        {
            FluidParticle[] start = ParticleSets.Random(1009, Domain, 0.5f, 2);
            Assert.That(Run(Water(4), start, 30, out _), Is.EqualTo(Run(Water(4), start, 30, out _)));
        }

        // 200 particles within R of each other: no list holds them, so steps that keep the order search among those of the cells at the
        // sort.
        [Test]
        public void WhoHasMoreNeighboursThanTheListHoldsIsPushedAsByASearch()
        {
            FluidParticle[] start = ParticleSets.Random(200, Vector3.one * (0.9f * Spacing), 0f, 7);
            FluidSolverSettings Slow(int steps)
            {
                FluidSolverSettings settings = Water(steps);
                settings.TimeStep *= 1e-3f;
                return settings;
            }
            FluidParticle[] kept = Run(Slow(4), start, 4, out _), fresh = Run(Slow(1), start, 4, out _);
            float fastest = fresh.Max(p => p.VelT0.magnitude);
            Assert.That(fastest, Is.GreaterThan(0f));
            for (int i = 0; i < start.Length; i++)
            {
                Assert.That((kept[i].VelT0 - fresh[i].VelT0).magnitude, Is.LessThan(1e-3f * fastest), $"particle {i}");
            }
        }

        // Two slabs a little farther apart than R that close by 0.8 or 1.2 R in the steps of one list: seen only at the next sort they
        // would go on as if they were alone.
        [TestCase(8, 0.8f)]
        [TestCase(16, 1.2f)]
        public void BodiesThatMeetBetweenTwoSortsAreSeenAhead(int steps, float closing)
        {
            FluidSolverSettings Meeting(int served)
            {
                FluidSolverSettings settings = Water(served);
                settings.Gravity = Vector3.zero;
                return settings;
            }
            FluidSolverSettings water = Meeting(steps);
            float radius = water.SupportRadius, speed = 0.5f * closing * radius / ((steps - 1) * water.TimeStep);
            FluidParticle[] slab = ParticleSets.Lattice(new Vector3Int(2, 6, 6), Spacing, 0f, 1);
            float half = slab.Max(p => p.Position.x) + 0.51f * radius;
            FluidParticle[] start = slab.Select(p => new FluidParticle(p.Position - half * Vector3.right, speed * Vector3.right, p.Id))
                .Concat(
                    slab.Select(p => new FluidParticle(p.Position + half * Vector3.right, speed * Vector3.left, p.Id + (uint)slab.Length)))
                    .ToArray();
            FluidParticle[] fresh = After(Meeting(1)), kept = After(water);
            double Momentum(FluidParticle[] particles) => particles.Take(slab.Length).Sum(p => (double)p.VelT0.x) / slab.Length;
            double stopped = speed - Momentum(fresh);
            Assert.That(stopped, Is.GreaterThan(0.01 * speed), "they have met");
            Assert.That(speed - Momentum(kept), Is.EqualTo(stopped).Within(20).Percent);

            // The first lists are of particles just loaded, which look nowhere ahead: a step before the block.
            FluidParticle[] After(FluidSolverSettings settings)
            {
                using (var rig = new StandardRig(settings, start))
                {
                    rig.Solver.FlowSpeed = 0f;
                    GpuTest.Run(cmd => rig.Solver.RecordSteps(cmd, 1));
                    rig.Steps(steps);
                    return rig.Particles().OrderBy(p => p.Id).ToArray();
                }
            }
        }

        [TestCase(0.0, double.PositiveInfinity)]
        [TestCase(0.1, 6.0)] // two at R/10 a step close a fifth
        [TestCase(0.31, 1.0)]
        [TestCase(0.61, 0.0)]
        public void ListsServeUntilTwoBodiesMayHaveClosed(double radiiAStep, double expected)
        {
            FluidSolverSettings settings = Water(8);
            const double step = 1.0 / 240.0;
            double speed = 0.999 * radiiAStep * settings.SupportRadius / step;
            Assert.That(ListReuse.StepsAfter(settings, step, speed, 1.2), Is.EqualTo(expected));
            using (var rig = new StandardStateRig(settings, 64))
            {
                Assert.That(ListReuse.StepsAfter(rig.State, 10, step, speed, 1.2), Is.EqualTo(expected));
            }
        }

        [TestCase(5f, 0.04f, 1.2)]
        [TestCase(6f, 0.02f, 1.2)]
        [TestCase(10f, 0.04f, 0.72)]
        [TestCase(5f, 0.005f, 0.72)] // c of liquid at rest is then ten times the speed of its fall
        [TestCase(12f, 0.04f, 0.6)]
        [TestCase(20f, 0.0025f, 0.6)]
        public void StiffLiquidHasFresherLists(float ratio, float compression, double closing)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            (input.Spacing, input.LiquidDepth, input.SoundSpeedRatio, input.MaxCompression) = (0.02f, 0.5f, ratio, compression);
            Assert.That(StandardRules.ListClosing(StandardRules.Derive(input).Own<StandardSettings>()), Is.EqualTo(closing).Within(1e-6));
        }

        [TestCase(0.07f, false, double.PositiveInfinity, 8, 0.6)]
        [TestCase(0f, true, double.PositiveInfinity, 8, 0.6)]
        [TestCase(0f, true, 6.0, 7, 0.6)]
        [TestCase(0f, false, double.PositiveInfinity, 16, 1.2)]
        [TestCase(0f, false, 6.0, 7, 1.2)]
        [TestCase(0f, false, 0.0, 1, 1.2)]
        public void ForcesOfTheirOwnHaveFresherLists(float tension, bool correction, double after, int expected, double closing)
        {
            FluidSolverSettings settings = Water(16).WithOwn((ref StandardSettings own) =>
                (own.SurfaceTension, own.GradientCorrection) = (tension, correction));
            Assert.That(StandardRules.ListClosing(settings.Own<StandardSettings>()), Is.EqualTo(closing).Within(1e-6));
            Assert.That(StandardRules.StepsPerSort(settings.Own<StandardSettings>(), after), Is.EqualTo(expected));
            settings = settings.WithOwn((ref StandardSettings own) => own.StepsPerSort = 1);
            Assert.That(StandardRules.StepsPerSort(settings.Own<StandardSettings>(), after), Is.EqualTo(1));
        }

        // A list that is emptied behind the solver's back tells who reads it.
        [Test]
        public void OtherConstantsGoOnWithTheListsThatAreThere()
        {
            FluidSolverSettings settings = Water(8), stiffer = settings.WithSoundSpeed(1.5f * settings.SoundSpeed);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(5, 5, 5), Spacing, 0.1f * Spacing, 3);
            using (StandardRig rig = new StandardRig(settings, start), fresh = new StandardRig(stiffer, start))
            {
                rig.Setup();
                fresh.Setup();
                rig.Solver.ApplySettings(stiffer);
                rig.Setup();
                Assert.That(rig.Densities(), Is.EqualTo(fresh.Densities()).Within(1e-3f));
                Assert.That(rig.Pressures(), Is.EqualTo(fresh.Pressures()).Within(0.1f));
                rig.State.List.Counts.SetData(new uint[start.Length]);
                rig.Solver.ApplySettings(settings);
                rig.Setup();
                Assert.That(rig.Densities().Max(), Is.LessThan(0.6f * fresh.Densities().Min()), "it searches");
                rig.Steps(1);
                Assert.That(rig.Densities().Min(), Is.GreaterThan(0.9f * fresh.Densities().Min()), "who steps sorts and lists anew");
            }
        }

        [Test]
        public void WithoutListsEveryStepSorts()
        {
            FluidSolverSettings settings = Water(8).WithOwn((ref StandardSettings own) => own.NeighbourList = false);
            Run(settings, ParticleSets.Random(65, Domain, 0.1f, 1), 6, out long setups);
            Assert.That(setups, Is.EqualTo(6 + 1), "and for those who read at the end");
        }

        // Beyond an open face a particle goes on freely until the next sort, and is taken out then.
        [Test]
        public void LiquidLeavesThroughOpenFacesAtTheNextSort()
        {
            FluidSolverSettings settings = Water(8);
            settings.Boundaries.Open = FluidFaces.LowY;
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(5, 5, 5), Spacing, 0.02f * Spacing, 5);
            using (var rig = new StandardRig(settings, start))
            {
                rig.Solver.FlowSpeed = 0f;
                for (int turn = 0; turn < 60 && rig.Solver.ReadCountersNow().Removed < start.Length; turn++)
                {
                    rig.Steps(16);
                    FluidParticle[] particles = rig.Particles();
                    Assert.That(particles.Where(p => !p.IsRemoved).Select(p => p.Id), Is.Unique);
                    Assert.That(particles.All(p => p.IsRemoved || p.Position.y >= -0.5f * Domain.y),
                        "at a sort nobody is beyond an open face");
                }
                Assert.That(rig.Solver.ReadCountersNow().Removed, Is.EqualTo(start.Length));
            }
        }

        [TestCase(0)]
        [TestCase(-3)]
        public void ANumberOfStepsBelowOneIsNamed(int steps) => Assert.That(() => Water(steps).Own<StandardSettings>().Validate(),
            Throws.ArgumentException.With.Message.Contains("StepsPerSort"));
    }
}
