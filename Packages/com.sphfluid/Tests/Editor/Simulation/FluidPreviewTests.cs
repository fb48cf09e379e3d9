using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What is shown of a start before it: filled once, again after a change, evenly chosen points, the places of leaks.</summary>
    public sealed class FluidPreviewTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidVolume volume;
        private PreviewMemory memory;
        private List<FluidMessage> messages;
        private double now;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create(liquid: false);
            volume = rig.AddVolume(simulation);
            memory = new PreviewMemory();
            messages = null;
        }

        [TearDown]
        public void TearDown()
        {
            memory.Dispose();
            rig.Dispose();
        }

        [Test]
        public void ThePointsAreTheParticlesOfTheStart()
        {
            Assert.That(Look());
            SpawnResult filled = Filled();
            Assert.That(memory.Preview.Particles, Is.EqualTo(64));
            Assert.That(memory.Points.Shown.OrderBy(Order), Is.EqualTo(filled.Particles.Select(p => p.Position).OrderBy(Order)));
        }

        [Test]
        public void TheInspectorSaysHowDeepAndHowWrongItIsAndWhatHalfTheSpacingCosts()
        {
            Look();
            double layers = memory.Preview.Depth / memory.Preview.Constants.Spacing;
            double depth = 64.0 * System.Math.Pow(simulation.Spacing, 3.0) / simulation.DomainSize.x / simulation.DomainSize.z;
            Dictionary<string, string> text =
                SphFluid.Editor.DomainText.Before(simulation, memory.Preview).Lines.ToDictionary(l => l.Label, l => l.Value);
            double steps = 2.0 / 60.0 / SphFluid.Editor.TimeStepText.StepOf(simulation, memory.Preview.Constants);

            Assert.That(memory.Preview.Depth, Is.EqualTo(depth).Within(1e-4 * depth));
            Assert.That(text["Error class"],
                Is.EqualTo(SphFluid.Editor.ErrorClass.Describe(simulation.Method, simulation.Profile.SupportRatio, layers)));
            Assert.That(text["Half the spacing"],
                Does.StartWith(System.FormattableString.Invariant($"512 particles, {steps:0.#} steps a frame"))
                .And.Contain("class " +
                    SphFluid.Editor.ErrorClass.Describe(simulation.Method, simulation.Profile.SupportRatio, 2.0 * layers)));
        }

        [Test]
        public void WithoutGravityThereIsNoDepthAndNoClass()
        {
            (simulation.UseSceneGravity, simulation.Gravity) = (false, Vector3.zero);
            Look();

            Assert.That(memory.Preview.Depth, Is.Zero);
            Assert.That(SphFluid.Editor.DomainText.Before(simulation, memory.Preview).Lines.Single(l => l.Label == "Error class").Value,
                Does.StartWith("none: without gravity"));
        }

        [Test]
        public void LiquidIsFilledAgainOnlyAfterAChange()
        {
            Look();
            Look();
            Assert.That(memory.Fills, Is.EqualTo(1));
            FillPoints before = memory.Points;
            volume.transform.localPosition = new Vector3(0.02f, 0f, 0f);
            Look();
            Assert.That(memory.Fills, Is.EqualTo(2));
            Assert.That(memory.Points, Is.Not.SameAs(before));
            rig.Profile.RestDensity = 900f;
            Look();
            Assert.That(memory.Fills, Is.EqualTo(3));
        }

        [Test]
        public void AColliderThatMovesIntoTheLiquidFillsItAgain()
        {
            Look();
            GameObject cube = GameObject.CreatePrimitive(PrimitiveType.Cube);
            cube.layer = SimulationRig.Layer;
            cube.transform.localScale = 0.1f * Vector3.one;
            try
            {
                Look();
                Assert.That(memory.Fills, Is.EqualTo(2));
                Assert.That(memory.Points.Total, Is.LessThan(64));
                Look();
                Assert.That(memory.Fills, Is.EqualTo(2));
            }
            finally
            {
                Object.DestroyImmediate(cube);
            }
        }

        [Test]
        public void MessagesAreThoseOfACheck()
        {
            volume.transform.localPosition = new Vector3(0.15f, 0f, 0f);
            for (int look = 0; look < 2; look++)
            {
                Look();
                Assert.That(messages.Select(m => m.ToString()), Is.EqualTo(simulation.Validate().Select(m => m.ToString())).And.Not.Empty);
            }
        }

        [Test]
        public void FillingCanBeCancelledUntilTheNextChange()
        {
            simulation.Spacing = 0.008f; // 15,625 particles
            Assert.That(memory.Look(simulation.Spec, FluidScene.Volumes(simulation), now, _ => false, ref messages), Is.False);
            Assert.That((memory.IsCancelled, memory.Points, memory.Preview), Is.EqualTo((true, (FillPoints)null, (FluidPreview)null)));
            Assert.That(Look(), Is.False, "nothing changed");
            volume.Size = 0.19f * Vector3.one;
            Assert.That(Look());
            Assert.That(memory.IsCancelled, Is.False);
            Assert.That(memory.Preview.Particles, Is.GreaterThan(10000));
        }

        [Test]
        public void LongFillsWaitForAnIdleMoment()
        {
            simulation.Spacing = 0.008f;
            Assert.That(memory.Look(simulation.Spec, FluidScene.Volumes(simulation), now, Slow, ref messages));
            volume.Size = 0.19f * Vector3.one;
            now += 0.5;
            Assert.That(Look(), Is.False);
            Assert.That((memory.Waits, memory.Fills), Is.EqualTo((true, 1)));
            now += 0.9 * PreviewMemory.Idle;
            volume.Size = 0.18f * Vector3.one;
            Assert.That(Look(), Is.False, "it still changes");
            now += 1.1 * PreviewMemory.Idle;
            Assert.That(Look());
            Assert.That((memory.Waits, memory.Fills), Is.EqualTo((false, 2)));
        }

        [Test]
        public void TooManyPointsAreChosenEvenly()
        {
            const int side = 30, most = 1000;
            var particles = new List<FluidParticle>();
            for (int i = 0; i < side * side * side; i++)
            {
                particles.Add(new FluidParticle(new Vector3(i % side, i / side % side, i / (side * side)), Vector3.zero, (uint)i));
            }
            var points = new FillPoints(particles, most);
            Assert.That((points.Total, points.Shown.Count), Is.EqualTo((side * side * side, most)));
            Assert.That(points.Shown.Distinct().Count(), Is.EqualTo(most));
            // Of 27 equal blocks each should have 37; random choice has a standard deviation of 6.
            int[] blocks = points.Shown.GroupBy(p => ((int)p.x / 10, (int)p.y / 10, (int)p.z / 10)).Select(g => g.Count()).ToArray();
            Assert.That(blocks.Length, Is.EqualTo(27));
            Assert.That(blocks, Is.All.InRange(25, 50));
        }

        [Test]
        public void FewPointsAreAllShown([Values(0, 1, 2, 3, 7)] int count)
        {
            var particles = Enumerable.Range(0, count).Select(i => new FluidParticle(new Vector3(i, 0f, 0f), Vector3.zero, (uint)i))
                .ToList();
            Assert.That(new FillPoints(particles, 7).Shown.Select(p => p.x), Is.EqualTo(Enumerable.Range(0, count)));
            Assert.That(new FillPoints(particles, 2).Shown.Distinct().Count(), Is.EqualTo(Mathf.Min(count, 2)));
        }

        [Test]
        public void ALeakIsShownWhereTheMessageIs()
        {
            volume.Shape = FluidVolumeShape.Vessel;
            volume.Level = 0.1f;
            Look();
            string text = messages.Single(m => m.Issue == FluidIssue.VesselLeaks).Text;
            Vector3 leak = simulation.LocalToWorld.MultiplyPoint3x4(memory.Leaks.Single());
            Assert.That(text, Does.Contain(System.FormattableString.Invariant($"near ({leak.x:0.###}, {leak.y:0.###}, {leak.z:0.###})")));
            Assert.That(memory.Preview, Is.Null, "it cannot start");
        }

        [Test]
        public void ARelaxedStartIsShownWhereItComesToRest()
        {
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f);
            volume.Size = new Vector3(0.4f, 0.2f, 0.4f);
            Look();
            FillPoints lattice = memory.Points;
            var said = new List<FluidMessage>();
            Assert.That(memory.TryRelax(simulation.Spec, FluidScene.Volumes(simulation), default, said.Add));
            Assert.That(memory.IsRelaxed);
            Assert.That(memory.Points.Total, Is.EqualTo(lattice.Total));
            Assert.That(memory.Points.Shown, Is.Not.EqualTo(lattice.Shown));
            Assert.That(said.Select(m => m.Issue), Is.EqualTo(new[] { FluidIssue.StartRelaxation }));
            Look();
            Assert.That(memory.IsRelaxed, "nothing changed");
            volume.Size = new Vector3(0.4f, 0.15f, 0.4f);
            Look();
            Assert.That(memory.IsRelaxed, Is.False);
        }

        private bool Look() => memory.Look(simulation.Spec, FluidScene.Volumes(simulation), now, null, ref messages);

        private static bool Slow(double seconds)
        {
            System.Threading.Thread.Sleep((int)(1000.0 * PreviewMemory.Quick));
            return true;
        }

        private SpawnResult Filled()
        {
            using (var collision = new CollisionScene())
            {
                FluidSpec spec = simulation.Spec;
                var shapes = LiquidChecks.Shapes(spec, FluidScene.Volumes(simulation), collision, new List<FluidMessage>())
                    .ConvertAll(f => f.shape);
                return FluidSpawner.Fill(SpawnRequests.For(spec, shapes, collision));
            }
        }

        private static (float, float, float) Order(Vector3 p) => (p.x, p.y, p.z);
    }
}
