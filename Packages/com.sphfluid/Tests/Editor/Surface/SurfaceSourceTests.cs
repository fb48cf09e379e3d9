using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>When a component's surface is made anew.</summary>
    public sealed class SurfaceSourceTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3 Domain = new Vector3(0.9f, 0.7f, 0.5f);

        private FluidShaderSet shaders;
        private FluidParticle[] particles;
        private FluidSolver solver;
        private SurfaceSource source;
        private FluidSurfaceOptions options;
        private int drops;

        [SetUp]
        public void SetUp()
        {
            shaders = SurfaceTestScene.LoadShaders();
            particles = ParticleSets.Random(700, Domain, 0f, 3);
            solver = new FluidSolver(TestSettings.ByRule(Domain, Spacing), shaders, particles);
            source = new SurfaceSource(shaders);
            options = new FluidSurfaceOptions();
            drops = 0;
        }

        [TearDown]
        public void TearDown()
        {
            source?.Dispose();
            solver?.Dispose();
        }

        [Test]
        public void TheSurfaceOfALiquidThatTookNoStepStays()
        {
            Settle();
            int made = source.Surface.Recordings;
            for (int frame = 0; frame < 3; frame++) Assert.IsFalse(Make());
            Assert.AreEqual(made, source.Surface.Recordings);
        }

        [Test]
        public void AStepMakesItAnew()
        {
            Settle();
            GpuTest.Run(cmd => solver.RecordSteps(cmd, 1));
            Assert.IsTrue(Make());
            Settle();
            Assert.IsFalse(Make());
        }

        [Test]
        public void OtherParticlesAndOtherPhysicsMakeItAnew()
        {
            Settle();
            solver.SetParticles(particles);
            Assert.IsTrue(Make());
            Settle();
            solver.ApplySettings(solver.Settings);
            Assert.IsTrue(Make());
        }

        [Test]
        public void OtherOptionsMakeItAnew()
        {
            Settle();
            options.Quality = FluidSurfaceQuality.Cheap;
            Assert.IsTrue(Make());
            Settle();
            options.CellSize = 0.9f;
            Assert.IsTrue(Make());
            Settle();
            options.ClosedAtWalls = false;
            Assert.IsTrue(Make());
            Settle();
            options.TriangleBudget = 1000000;
            Assert.IsTrue(Make());
        }

        [Test]
        public void AnotherLiquidMakesItAnew()
        {
            Settle();
            using (var other = new FluidSolver(solver.Settings, shaders, particles))
            {
                Assert.IsTrue(source.Request(other, options, 0, shaders, out _));
                Assert.IsTrue(source.Make());
            }
            Assert.IsFalse(source.Make(), "of a liquid that is gone");
        }

        [Test]
        public void ASurfaceThatDoesNotFitIsMadeUntilItDoes()
        {
            options.TriangleBudget = 10;
            Make();
            source.Surface.ReadStatus();
            Assert.IsFalse(source.Surface.Status.IsComplete);
            Assert.IsTrue(Make());
        }

        [Test]
        public void AnAnswerThatIsOnItsWayIsAwaited()
        {
            Assert.IsTrue(Make());
            Assert.AreEqual(!SystemInfo.supportsAsyncGPUReadback, Make());
        }

        // What was read back may be about an earlier surface.
        [Test]
        public void AnUnfinishedReadBackDoesNotCount()
        {
            Settle();
            GpuTest.Run(cmd => solver.RecordSteps(cmd, 1));
            Assert.IsTrue(Make());
            Assert.IsFalse(source.Surface.IsSettled);
            source.Surface.ReadStatus();
            Assert.IsTrue(source.Surface.IsSettled);
        }

        private void Settle()
        {
            for (int frame = 0; frame < 5 && (frame == 0 || !source.Surface.IsSettled); frame++)
            {
                Make();
                source.Surface.ReadStatus();
            }
            Assert.IsTrue(source.Surface.IsSettled);
        }

        private bool Make()
        {
            Assert.IsTrue(source.Request(solver, options, drops, shaders, out _));
            return source.Make();
        }
    }
}
