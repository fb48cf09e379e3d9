using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Each verdict and cause once, on states that are made up, and not on the near side of its limit.</summary>
    public sealed class StabilityCriterionTests
    {
        [Test]
        public void PassesWhatRests()
        {
            StabilityScenario scene = StabilityStates.Scenario;
            scene.RestSpeed = 0.1;
            scene.Closed = true;

            StabilityOutcome outcome = Outcome(scene, StabilityStates.Column());

            Assert.That((outcome.Verdict, outcome.Cause, outcome.Reason), Is.EqualTo((StabilityVerdict.Stable, StabilityCause.None, "")));
            Assert.That(outcome.TimeToFailure, Is.NaN);
        }

        // 3 v_ref are 12 m/s.
        [TestCase(11.9f, StabilityCause.Energy)]
        [TestCase(12.1f, StabilityCause.Speed)]
        public void FailsOnSpeed(float speed, StabilityCause cause)
        {
            StabilityOutcome outcome = Outcome(StabilityStates.Scenario, Moving(i => i == 7 ? speed * Vector3.left : Vector3.zero));

            Assert.That((outcome.Verdict, outcome.Cause), Is.EqualTo((StabilityVerdict.Failed, cause)), outcome.Reason);
            Assert.That(outcome.TimeToFailure, Is.EqualTo(1.0));
        }

        // The column's energy is m g H/2 = 5 J a particle: ½ v² may be 0.25.
        [TestCase(0.70f, StabilityCause.None)]
        [TestCase(0.72f, StabilityCause.Energy)]
        public void FailsOnEnergyInMotion(float speed, StabilityCause cause)
        {
            Assert.That(Outcome(StabilityStates.Scenario, Moving(i => (i & 1) == 0 ? speed * Vector3.left : speed * Vector3.right)).Cause,
                Is.EqualTo(cause));
        }

        // m c² (ln 1.08 + 1/1.08 − 1) = 100 · 0.00288705 = 0.289 J a particle, beyond 0.25; at 1.07 it is 0.224.
        [TestCase(1070f, StabilityCause.None)]
        [TestCase(1080f, StabilityCause.Energy)]
        [TestCase(900f, StabilityCause.None)] // suction does not act
        public void FailsOnEnergyInCompression(float density, StabilityCause cause)
        {
            Assert.That(Outcome(StabilityStates.Scenario, StabilityStates.Column(null, density)).Cause, Is.EqualTo(cause));
        }

        [Test]
        public void ComparesEnergyWithItsScaleAtRest()
        {
            StabilityScenario scene = StabilityStates.Scenario;
            scene.EnergyScale = 100.0 * StabilityStates.Count;

            Assert.That(Outcome(scene, Moving(i => 3f * Vector3.left)).Verdict, Is.Not.EqualTo(StabilityVerdict.Failed));
        }

        // 0.1 % of 160 particles is less than one.
        [TestCase(0.049f, StabilityCause.None)]
        [TestCase(0.051f, StabilityCause.Escape)]
        public void FailsBeyondAWall(float depth, StabilityCause cause)
        {
            FluidSnapshot fallen =
                StabilityStates.Column((i, p) => i == 3 ? StabilityStates.At(p, new Vector3(0.3f, -1f - depth, 0.3f), Vector3.zero) : p);
            StabilityScenario slab = StabilityStates.Scenario;
            slab.WallTop = -0.95;
            FluidSnapshot through =
                StabilityStates.Column((i, p) => i == 3 ? StabilityStates.At(p, new Vector3(0.3f, -0.95f - depth, 0.3f), Vector3.zero) : p);

            Assert.That(Outcome(StabilityStates.Scenario, fallen).Cause, Is.EqualTo(cause), "the domain's");
            Assert.That(Outcome(slab, through).Cause, Is.EqualTo(cause), "a slab's");
        }

        [TestCase(1090f, StabilityCause.None)]
        [TestCase(1110f, StabilityCause.Compression)]
        public void FailsOnCompression(float density, StabilityCause cause)
        {
            StabilityScenario soft = StabilityStates.Scenario;
            soft.Setup.Settings = soft.Setup.Settings.WithOwn((ref ThesisSettings own) => own.Stiffness = 2f);

            Assert.That(Outcome(soft, StabilityStates.Column(null, density)).Cause, Is.EqualTo(cause));
        }

        [Test]
        public void FailsOnWhatIsNotANumber()
        {
            Assert.That(Outcome(StabilityStates.Scenario, Moving(i => i == 5 ? new Vector3(float.NaN, 0f, 0f) : Vector3.zero)).Cause,
                Is.EqualTo(StabilityCause.NotFinite));
            // Found by the solver before the criterion sees a state.
            var result = new CaseResult { Failure = "2 positions were not finite", Counters = new FluidCounters { NonFinite = 2 } };
            Assert.That(new StabilityCriterion(StabilityStates.Scenario).Conclude(result).Cause, Is.EqualTo(StabilityCause.NotFinite));
        }

        [TestCase(0.09f, StabilityCause.None)]
        [TestCase(0.11f, StabilityCause.Restless)]
        public void DegradesWhatDoesNotRest(float speed, StabilityCause cause)
        {
            StabilityScenario scene = StabilityStates.Scenario;
            scene.RestSpeed = 0.1;

            AssertDegraded(Outcome(scene, Moving(i => (i & 1) == 0 ? speed * Vector3.left : speed * Vector3.right)), cause);
        }

        // Two of 160 particles are 1.25 %. Across the periodic face from 0.38 to −0.38 it is 0.04.
        [TestCase(0.049f, FluidAxes.None, StabilityCause.Clumped)]
        [TestCase(0.051f, FluidAxes.None, StabilityCause.None)]
        [TestCase(0f, FluidAxes.X, StabilityCause.Clumped)]
        [TestCase(0f, FluidAxes.Y | FluidAxes.Z, StabilityCause.None)]
        public void DegradesWhatClumps(float apart, FluidAxes periodic, StabilityCause cause)
        {
            StabilityScenario scene = StabilityStates.Scenario;
            scene.Setup.Settings.Boundaries.Periodic = periodic;
            float one = apart > 0f ? 0.3f : 0.38f, other = apart > 0f ? 0.3f + apart : -0.38f;
            FluidSnapshot state =
                StabilityStates.Column((i, p) => i == 0 ? StabilityStates.At(p, new Vector3(one, -0.95f, 0.3f), Vector3.zero)
                : i == 1 ? StabilityStates.At(p, new Vector3(other, -0.95f, 0.3f), Vector3.zero) : p);

            AssertDegraded(Outcome(scene, state), cause);
        }

        // m = 10: height 10 ln 1.1 = 0.9531; with 2 % less 0.9331.
        [TestCase(0.940f, StabilityCause.None)]
        [TestCase(0.925f, StabilityCause.Sunk)]
        public void DegradesWhatSinks(float height, StabilityCause cause)
        {
            StabilityScenario scene = StabilityStates.Scenario;
            scene.Depth = 1.0;
            float scale = (height - 0.05f) / 0.95f; // of the places of the particles, the highest at 0.95
            FluidSnapshot state = StabilityStates.Column((i, p) =>
                StabilityStates.At(p, new Vector3(p.Position.x, -1f + (p.Position.y + 1f) * scale, p.Position.z), Vector3.zero));

            AssertDegraded(Outcome(scene, state), cause);
        }

        [TestCase(0, 0, StabilityCause.None)]
        [TestCase(1, 0, StabilityCause.Clamped)]
        [TestCase(0, 1, StabilityCause.Clamped)]
        public void DegradesWhatWasClamped(int accelerations, int positions, StabilityCause cause)
        {
            var counters = new FluidCounters { AccelerationLimitHits = accelerations, DomainClamps = positions };

            AssertDegraded(Outcome(StabilityStates.Scenario, StabilityStates.Column(), counters), cause);
        }

        // Half of the particles move at 0.5 m/s in each direction, 80 kg m/s in all; one in 1,000 of it is 0.08.
        [TestCase(true, 0.0009f, StabilityCause.None)]
        [TestCase(true, 0.0011f, StabilityCause.Drift)]
        [TestCase(false, 0.0011f, StabilityCause.None)]
        public void DegradesWhatLosesItsMomentum(bool closed, float drift, StabilityCause cause)
        {
            StabilityScenario scene = StabilityStates.Scenario;
            scene.Closed = closed;
            FluidSnapshot State(float more) => Moving(i => new Vector3(((i & 1) == 0 ? 0.5f : -0.5f) + more, 0f, 0f));
            var criterion = new StabilityCriterion(scene);
            criterion.Sample(0.0, State(0f));
            criterion.Sample(1.0, State(0.5f * drift));

            AssertDegraded(criterion.Conclude(Result(criterion, default)), cause);
        }

        [Test]
        public void SaysThatARunWasCutShort()
        {
            var criterion = new StabilityCriterion(StabilityStates.Scenario);
            criterion.Sample(0.0, StabilityStates.Column());

            StabilityOutcome outcome = criterion.Conclude(Result(criterion, default), StabilityScenario.CutText + " of 5 steps");

            Assert.That((outcome.Verdict, outcome.IsCut), Is.EqualTo((StabilityVerdict.Stable, true)));
        }

        private static void AssertDegraded(StabilityOutcome outcome, StabilityCause cause)
        {
            StabilityVerdict verdict = cause == StabilityCause.None ? StabilityVerdict.Stable : StabilityVerdict.Degraded;
            Assert.That((outcome.Verdict, outcome.Cause), Is.EqualTo((verdict, cause)), outcome.Reason);
        }

        private static FluidSnapshot Moving(Func<int, Vector3> velocity) =>
            StabilityStates.Column((i, p) => StabilityStates.At(p, p.Position, velocity(i)));

        private static StabilityOutcome Outcome(StabilityScenario scene, FluidSnapshot end, FluidCounters counters = default)
        {
            var criterion = new StabilityCriterion(scene);
            criterion.Sample(0.0, StabilityStates.Column());
            criterion.Sample(1.0, end);
            return criterion.Conclude(Result(criterion, counters));
        }

        private static CaseResult Result(StabilityCriterion criterion, FluidCounters counters) =>
            new CaseResult { Failure = criterion.Failure, Counters = counters, Particles = StabilityStates.Count, SimulatedSeconds = 1.0 };
    }
}
