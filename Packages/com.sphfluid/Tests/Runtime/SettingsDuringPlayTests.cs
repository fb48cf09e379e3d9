using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Changed settings take effect: at once where the liquid can go on, else by a new start.</summary>
    public sealed class SettingsDuringPlayTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create();
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator GravityTimeStepAndProfileConstantsGoOn()
        {
            yield return null;
            yield return null;
            FluidSolver solver = simulation.Solver;
            long steps = simulation.StepCount;
            simulation.UseSceneGravity = false;
            simulation.Gravity = new Vector3(0f, 3f, 0f);
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.FixedTimeStep = 0.0001f;
            simulation.Profile.RestDensity = 800f;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Assert.That(simulation.StepCount, Is.GreaterThan(steps));
            Assert.That(simulation.TimeStep, Is.EqualTo(0.0001f));
            Assert.That(solver.Settings.Gravity.y, Is.EqualTo(3f).Within(1e-5f));
            Assert.That(solver.Settings.RestDensity, Is.EqualTo(800f));
        }

        [UnityTest]
        public IEnumerator ADraggedDomainStartsAgainOnceWhenLetGo()
        {
            int starts = 0;
            simulation.Started += _ => starts++;
            FluidSolver solver = simulation.Solver;
            simulation.StartsLater = true;
            for (int i = 1; i <= 3; i++)
            {
                simulation.DomainSize = new Vector3(0.4f + 0.1f * i, 0.4f, 0.4f);
                yield return null;
                Assert.That(simulation.Solver, Is.SameAs(solver), "the liquid stays while it is dragged");
            }
            simulation.StartsLater = false;
            yield return null;
            yield return null;
            Assert.That(starts, Is.EqualTo(1));
            Assert.That(simulation.Solver.Settings.DomainSize.x, Is.EqualTo(0.7f).Within(1e-6f));
        }

        [UnityTest]
        public IEnumerator AnotherLiquidStartsAgainAndOnlyItsLookDoesNot()
        {
            simulation.Profile = null;
            FluidLiquid water = Liquid("Water");
            simulation.Liquid = water;
            yield return null;
            yield return null;
            FluidSolver solver = simulation.Solver;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
            simulation.Liquid = Object.Instantiate(water);
            simulation.Liquid.Water.ColorAtOneMetre = Color.red;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Object.Destroy(simulation.Liquid);
            simulation.Liquid = Liquid("Lava");
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));
            Assert.That(simulation.Solver.Settings.RestDensity, Is.EqualTo(2700f));
        }

        [UnityTest]
        public IEnumerator ALiquidThatAnEmitterGaveStaysWhenTheEmitterIsDisabled()
        {
            GameObject tap = rig.NewObject("Tap");
            tap.transform.SetParent(simulation.transform, false);
            tap.transform.localPosition = 0.15f * Vector3.up;
            FluidEmitter emitter = tap.AddComponent<FluidEmitter>();
            emitter.Liquid = Liquid("Milk");
            simulation.Profile = null;
            yield return null;
            yield return null;
            FluidSolver solver = simulation.Solver;
            Assert.That(simulation.ActiveLiquid, Is.EqualTo(emitter.Liquid));
            Assert.That(solver.Settings.RestDensity, Is.EqualTo(1030f));
            emitter.enabled = false;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
        }

        private static FluidLiquid Liquid(string name) =>
            TestAssets.Load<FluidLiquid>($"Packages/com.sphfluid/Runtime/Assets/Liquids/{name}.asset");

        [UnityTest]
        public IEnumerator ThesisSwitchesGoOnButTheSearchStartsAgain()
        {
            simulation.Method = FluidMethodKind.Thesis;
            yield return null;
            yield return null;
            FluidSolver solver = simulation.Solver;
            ThesisSwitches switches = ThesisSwitches.Corrected;
            switches.PressureHalf = false;
            simulation.Profile.ThesisSwitches = switches;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Assert.That(solver.Settings.Own<ThesisSettings>().PressureHalf, Is.False);
            switches.OctantSearch = false;
            simulation.Profile.ThesisSwitches = switches;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));
            Assert.That(simulation.Solver.Grid.CellSize.x, Is.EqualTo(simulation.Solver.Settings.SupportRadius));
        }

        [UnityTest]
        public IEnumerator ThePrintedMethodDoesNotAskTheProfile()
        {
            simulation.Method = FluidMethodKind.ThesisPrinted;
            yield return null;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver.Kind, Is.EqualTo(FluidMethodKind.ThesisPrinted));
            Assert.That(simulation.Solver.Settings.Own<ThesisSettings>().ForceTimesMass, Is.True);
            Assert.That(simulation.StepCount, Is.GreaterThan(0));
        }

        [UnityTest]
        public IEnumerator TurningTheDomainTurnsGravity()
        {
            simulation.transform.rotation = Quaternion.Euler(0f, 0f, 90f);
            yield return null;
            yield return null;
            Vector3 gravity = simulation.Solver.Settings.Gravity;
            Assert.That((gravity - new Vector3(Physics.gravity.y, 0f, 0f)).magnitude, Is.LessThan(1e-3f), gravity.ToString());
        }

        [UnityTest]
        public IEnumerator SpacingDomainAndProfileStartAgain()
        {
            yield return null;
            FluidSolver solver = simulation.Solver;
            GraphicsBuffer buffer = solver.Particles;
            simulation.Spacing = 0.04f;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));
            Assert.That(buffer.IsValid(), Is.False);
            Assert.That(simulation.ParticleCount, Is.EqualTo(125));

            solver = simulation.Solver;
            simulation.DomainSize = new Vector3(0.5f, 0.5f, 0.5f);
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));

            solver = simulation.Solver;
            FluidProfile copy = Object.Instantiate(rig.Profile);
            simulation.Profile = copy;
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));
            simulation.enabled = false;
            Object.DestroyImmediate(copy);
        }

        [UnityTest]
        public IEnumerator PeriodicAxesAndVelocityFieldsStartAgainButWallsAndForcesGoOn()
        {
            yield return null;
            FluidSolver solver = simulation.Solver;
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.Z };
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));
            Assert.That(simulation.Solver.Settings.Boundaries.Periodic, Is.EqualTo(FluidAxes.Z));

            solver = simulation.Solver;
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.Z, NoSlip = true, LowY = new Vector3(9f, 0f, 0f) };
            simulation.BodyForce = new FluidBodyForce { RateSquared = new Vector3(4f, 0f, 0f) };
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Assert.That(solver.Settings.Boundaries, Is.EqualTo(simulation.Boundaries));
            Assert.That(solver.Settings.BodyForce, Is.EqualTo(simulation.BodyForce));
            Assert.That(solver.Settings.MaxSpeed, Is.EqualTo(9f), "the wall is faster than the fall");

            simulation.VelocityField = position => new Vector3(0f, 0f, 10f * position.x);
            yield return null;
            yield return null;
            Assert.That(simulation.Solver, Is.Not.SameAs(solver));
            solver = simulation.Solver;
            yield return null;
            Assert.That(simulation.Solver, Is.SameAs(solver));
        }

        [UnityTest]
        public IEnumerator AWrongFaceIsReportedWithItsCureAndTheRightOneStartsAgain()
        {
            yield return null;
            yield return null;
            simulation.Boundaries = new FluidBoundaries { NoSlip = true, HighZ = new Vector3(0f, 0f, float.NaN) };
            LogAssert.Expect(LogType.Error, new Regex(@"\[SPH Fluid\] 'Fluid': The wall velocity Boundaries\.HighZ is"));
            for (int frame = 0; frame < 4; frame++) yield return null;
            Assert.That(simulation.IsRunning, Is.False);
            Assert.That(simulation.Messages[simulation.Messages.Count - 1].Issue, Is.EqualTo(FluidIssue.BoundariesInvalid));
            simulation.Boundaries = default;
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
        }

        [UnityTest]
        public IEnumerator AWrongSettingIsReportedOnceAndTheRightOneStartsAgain()
        {
            yield return null;
            simulation.DomainSize = new Vector3(0.4f, -1f, 0.4f);
            LogAssert.Expect(LogType.Error, new Regex(@"\[SPH Fluid\] 'Fluid': The domain size is"));
            for (int frame = 0; frame < 4; frame++) yield return null;
            Assert.That(simulation.IsRunning, Is.False);
            simulation.DomainSize = new Vector3(0.4f, 0.4f, 0.4f);
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
        }

        [UnityTest]
        public IEnumerator ColliderThatMovesInIsCollidedWith()
        {
            yield return null;
            BoxCollider box = rig.NewObject("Late Box").AddComponent<BoxCollider>();
            box.size = new Vector3(0.1f, 0.1f, 0.1f);
            box.transform.position = new Vector3(0f, -0.15f, 0f);
            yield return null;
            yield return null;
            Assert.That(simulation.Collision.Colliders.Count, Is.EqualTo(1));
            box.transform.position = new Vector3(0.1f, -0.15f, 0f);
            yield return null;
            yield return null;
            Assert.That(simulation.Collision.Colliders[0].BoundsMin.x, Is.EqualTo(0.05f).Within(1e-4f));
            Object.DestroyImmediate(box.gameObject);
            yield return null;
            yield return null;
            Assert.That(simulation.Collision.Colliders, Is.Empty);
        }

        [UnityTest]
        public IEnumerator SubstepCapSlowsTimeAndSaysSoOnce()
        {
            yield return null;
            int frames = SubstepMonitor.StartFrames + (int)(SubstepMonitor.LastingTime / 0.01) + 10;
            simulation.MaxSubstepsPerFrame = 1;
            LogAssert.Expect(LogType.Warning,
                new Regex(@"\[SPH Fluid\] 'Fluid': A frame of 10 ms needs \d+ steps of .* at most 1 are allowed.*Max Substeps Per Frame"));
            double before = simulation.SimulatedTime;
            int reported = 0;
            simulation.Reported += message => reported += message.Issue == FluidIssue.SubstepCap ? 1 : 0;
            for (int frame = 0; frame < frames; frame++) yield return null;
            Assert.That(simulation.SimulatedTime - before, Is.LessThan(0.9 * 0.01 * frames));
            Assert.That(simulation.CapHits, Is.GreaterThanOrEqualTo(frames - 2));
            Assert.That(simulation.RealTimeFactor, Is.LessThan(0.9));
            Assert.That(reported, Is.EqualTo(1));
        }

        // A shader that compiles, a scene that loads, a window that is dragged: Time.maximumDeltaTime at the most.
        [UnityTest]
        public IEnumerator OneLongFrameLogsNothing()
        {
            simulation.MaxSubstepsPerFrame = 8;
            for (int frame = 0; frame < 10; frame++)
            {
                Time.captureDeltaTime = frame == 6 ? 1f / 3f : 0.01f;
                yield return null;
            }
            Time.captureDeltaTime = 0.01f;
            Assert.That(simulation.CapHits, Is.EqualTo(1));
            Assert.That(simulation.Messages.Select(m => m.ToString()), Is.Empty);
            LogAssert.NoUnexpectedReceived();
        }
    }
}
