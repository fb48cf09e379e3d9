using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>The first moments of each scene: nothing leaks, sticks or gains energy.</summary>
    public sealed class LeakSceneTests
    {
        private static LeakResult Play(LeakScene scene)
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                using (var run = new LeakRun(scene, shaders))
                    return run.RunToEnd();
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }

        // Of a pool, what is in the surfaces or within the support radius of them, at the start or at the end, feels them: the rest only
        // takes time.
        private static void KeepNear(LeakScene scene)
        {
            var meshes = new List<TriangleMesh>();
            foreach (LeakBody body in scene.Bodies.Where(b => b.Mesh.IsClosed))
                foreach (int frame in new[] { 0, scene.Frames })
                {
                    meshes
                        .Add(
                            TriangleMesh.FromCorners((body.Shape?.Invoke(frame) ?? body.Surface).Select(body.PoseAt(frame).ToSimulation)
                                .ToArray()));
                }
            if (meshes.Count == 0) return;
            float reach = scene.Settings.SupportRadius;
            scene.Particles = CaseLattice.Particles(scene.Particles.Select(p => p.Position)
                .Where(p => meshes.Any(m => m.Contains(p) || m.IsNear(p, reach))).ToList());
        }

        [TestCase("cup", 5.0, 12)]
        [TestCase("cup", 150.0, 3)]
        [TestCase("funnel", 0.0, 16)]
        [TestCase("bunny", 0.0, 6)]
        [TestCase("knife", 10.0, 7)]
        [TestCase("wall", 3.0, 15)]
        [TestCase("sizes", 5.0, 3)]
        [TestCase("coplanar", 5.0, 5)]
        [TestCase("pulse-50", 3.77, 12)]
        [TestCase("uneven-50", 3.77, 8)]
        [TestCase("spin", 10.0, 10)]
        [TestCase("shear", 3.016, 18)]
        [TestCase("grow", 1.0, 7)]
        [TestCase("afloat", 2.0, 5)]
        [TestCase("waved", 2.0, 2)]
        [TestCase("wrung", 1.0, 2)]
        [TestCase("wheel", 20.0, 5)]
        public void NothingLeaks(string name, double speed, int frames)
        {
            LeakScene scene = LeakSceneEntry.Find(name).Build(speed);
            scene.Frames = frames;
            KeepNear(scene);

            LeakResult result = Play(scene);

            TestContext.WriteLine($"{scene.Particles.Length} particles, {result.Steps} steps, {result.Counters.Contacts} contacts");
            Assert.That(result.Escapes, Is.Zero);
            Assert.That(result.Failure, Is.Empty);
            Assert.That(result.Counters.Overlaps, Is.Zero);
        }

        [TestCase("bumped", 10.0, 6)]
        [TestCase("pressed", 10.0, 6)]
        public void WhereNoPlaceIsLeftEveryEscapeIsNamed(string name, double speed, int frames)
        {
            LeakScene scene = LeakSceneEntry.Find(name).Build(speed);
            scene.Frames = frames;
            KeepNear(scene);

            LeakResult result = Play(scene);

            TestContext.WriteLine(
                $"{scene.Particles.Length} particles, {result.Steps} steps, {result.Counters.Contacts} contacts, " +
                $"{result.Counters.Squeezed} squeezed, {result.Escapes} escaped");
            Assert.That(result.Counters.Squeezed, Is.Positive);
            Assert.That(result.Escapes, Is.LessThanOrEqualTo(result.Counters.Squeezed));
            Assert.That(result.Failure, Is.Empty);
        }

        [Test]
        public void LiquidInACupRestsHalfASpacingFromItsWalls()
        {
            LeakScene scene = LeakSceneEntry.Find("still-cup").Build(0.0);
            scene.Frames = 32;

            LeakResult result = Play(scene);

            TestContext.WriteLine(
                $"energy {result.EnergyRatio}, first layer {result.Rest.Value.FirstLayer}, pressed {result.Rest.Value.Pressed}, held " +
                $"{result.Rest.Value.Held}");
            Assert.That(result.Failure, Is.Empty);
            Assert.That(result.EnergyRatio, Is.LessThan(1.01));
            Assert.That(result.Rest.Value.FirstLayer, Is.EqualTo(0.5).Within(0.05));
            Assert.That(result.Rest.Value.Pressed, Is.LessThan(0.01));
            Assert.That(result.Rest.Value.Held, Is.Zero);
        }

        [Test]
        public void ASheetKeepsFlowAndRestApart()
        {
            LeakScene scene = LeakSceneEntry.Find("two-sided").Build(2.0);
            scene.Frames = 4;

            LeakResult result = Play(scene);

            TestContext.WriteLine($"drag {result.Drag}");
            Assert.That(result.Failure, Is.Empty);
            Assert.That(result.Drag, Is.LessThan(1e-4));
        }

        [TestCase("cup", 5.0, 6, 0.1)]
        [TestCase("pulse-50", 3.77, 12, 0.1)]
        [TestCase("grow", 1.0, 7, 0.08)]
        [TestCase("waved", 2.0, 3, 0.05)]
        [TestCase("wrung", 1.0, 3, 0.02)]
        [TestCase("pressed", 10.0, 8, 0.05)]
        public void TheDetectorsSeeWhatGoesThrough(string name, double speed, int frames, double share)
        {
            LeakScene scene = LeakSceneEntry.Find(name).Build(speed);
            scene.Solid = false;
            scene.Frames = frames;
            KeepNear(scene);

            LeakResult result = Play(scene);
            TestContext.WriteLine($"{result.Escapes} of {scene.Particles.Length} escaped, {result.Steps} steps");
            Assert.That(result.Escapes, Is.GreaterThan(share * scene.Particles.Length));
        }

        [Test]
        public void ASurfaceThatJumpsIsAFailure()
        {
            LeakScene scene = LeakSceneEntry.Find("cup").Build(180.0);
            scene.Frames = 2;

            LeakResult result = Play(scene);

            Assert.That(result.Jumps, Is.EqualTo(2));
            Assert.That(result.Failure, Is.Not.Empty);
        }

        [Test]
        public void ShakingFasterIsExpectedToTakeLonger()
        {
            // The same steps; at 165 m/s a cup takes seven times as long as at 1 m/s (LeakRun).
            LeakSceneEntry cup = LeakSceneEntry.Find("cup");
            Assert.That(LeakRun.CostOf(cup.Build(165.0)) / LeakRun.CostOf(cup.Build(1.0)), Is.InRange(4.0, 12.0));
        }

        [Test]
        public void PathsAgainstManyTrianglesAreExpectedToTakeLonger()
        {
            LeakScene few = LeakSceneEntry.Find("coplanar").Build(5.0), many = LeakSceneEntry.Find("sizes").Build(5.0);
            Assert.That(LeakRun.CostOf(many), Is.GreaterThan(1.5 * LeakRun.CostOf(few)));
        }

        [Test]
        public void ARunKnowsHowFarItIs()
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            LeakScene scene = LeakSceneEntry.Find("still-cup").Build(0.0);
            scene.Frames = 4;
            try
            {
                using (var run = new LeakRun(scene, shaders))
                {
                    var work = new SessionWork(run.Run());
                    work.Step();
                    work.Step();
                    Assert.That(run.Share, Is.EqualTo(0.5).Within(1e-9));
                }
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }
    }
}
