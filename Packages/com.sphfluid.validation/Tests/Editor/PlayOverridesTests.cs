using System.Text.RegularExpressions;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>What --surface does to the drawings of a simulation.</summary>
    public sealed class PlayOverridesTests
    {
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp() => simulation = new GameObject("Fluid").AddComponent<FluidSimulation>();

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(simulation.gameObject);

        [TestCase("particles")]
        [TestCase("cubes")]
        [TestCase("marching-cubes")]
        [TestCase("marching-cubes-gs")]
        [TestCase("none")]
        public void SurfaceIsReportedAsItWasAskedFor(string surface)
        {
            Apply(surface);
            Assert.AreEqual(surface, PlayOverrides.SurfaceOf(simulation));
        }

        [Test]
        public void ALiquidThatNothingDrawsIsNamedWithACure()
        {
            LogAssert.Expect(LogType.Warning,
                new Regex("'Fluid': No component draws this liquid.*--surface marching-cubes.*Fluid Surface Renderer"));
            PlayOverrides.Apply(PlayArguments.Parse(new[] { "player", "--" }), new[] { simulation });
        }

        [Test]
        public void PicturesWithoutALiquidAreSaidToBeMeant()
        {
            LogAssert.Expect(LogType.Log, new Regex("'Fluid': --surface none: pictures show the scene without this liquid.*--no-images"));
            Apply("none");
        }

        [Test]
        public void ABudgetThatNoLiquidOfTheSceneReadsIsRefused()
        {
            PlayArguments arguments = PlayArguments.Parse(new[] { "player", "--", "--surface", "particles", "--budget", "4" });
            Assert.That(() => PlayOverrides.Apply(arguments, new[] { simulation }),
                Throws.TypeOf<CommandLineException>().With.Message.StartsWith("--budget acts with --method automatic only, and no liquid"));

            simulation.Method = FluidMethodKind.Automatic;
            PlayOverrides.Apply(arguments, new[] { simulation });
            Assert.That(simulation.FrameBudget, Is.EqualTo(4f));
        }

        [Test]
        public void NumbersOfTheProfileLeaveTheAssetAsItIs()
        {
            FluidProfile asset = ScriptableObject.CreateInstance<FluidProfile>();
            simulation.Profile = asset;
            string[] line = { "player", "--", "--profile", "support-ratio=2, substeps=1" };
            PlayOverrides.Apply(PlayArguments.Parse(line), new[] { simulation });
            Assert.That((simulation.Profile.SupportRatio, simulation.Profile.Substeps), Is.EqualTo((2f, 1)));
            Assert.That((asset.SupportRatio, asset.Substeps), Is.EqualTo((2.25f, 4)));
            Object.DestroyImmediate(simulation.Profile);
            Object.DestroyImmediate(asset);
        }

        [TestCase("support-ratio=1", "--profile: support-ratio 1 is not a value that a profile may have; the nearest is 1.5.")]
        [TestCase("substeps=2.5", "--profile: substeps 2.5 is not a value that a profile may have; the nearest is 2.")]
        public void ANumberThatTheProfileCannotHaveIsRefused(string list, string message)
        {
            FluidProfile asset = ScriptableObject.CreateInstance<FluidProfile>();
            simulation.Profile = asset;
            PlayArguments arguments = PlayArguments.Parse(new[] { "player", "--", "--profile", list });
            Assert.That(() => PlayOverrides.Apply(arguments, new[] { simulation }),
                Throws.TypeOf<CommandLineException>().With.Message.EqualTo(message));
            Object.DestroyImmediate(asset);
        }

        [Test]
        public void ALiquidWithoutAProfileTakesNoNumbersOfOne()
        {
            PlayArguments arguments = PlayArguments.Parse(new[] { "player", "--", "--profile", "substeps=2" });
            Assert.That(() => PlayOverrides.Apply(arguments, new[] { simulation }),
                Throws.TypeOf<CommandLineException>().With.Message.StartsWith("--profile: 'Fluid' has no profile before it starts."));
        }

        [Test]
        public void StyleOfTheScenesRendererFollows()
        {
            var drawing = simulation.gameObject.AddComponent<FluidGeometrySurfaceRenderer>();
            Apply("cubes");
            Assert.AreEqual(FluidSurfaceStyle.Cubes, drawing.Style);
            Assert.AreEqual(1, simulation.GetComponents<FluidRenderer>().Length, "no second renderer");

            Apply("marching-cubes-gs");
            Assert.AreEqual(FluidSurfaceStyle.MarchingCubes, drawing.Style);

            Apply("particles");
            Assert.IsFalse(drawing.enabled);
            Assert.AreEqual("particles", PlayOverrides.SurfaceOf(simulation));
        }

        [Test]
        public void MoreParticlesThanFitAreRefusedBeforeALatticeIsMade()
        {
            // A volume whose lattice of 10^9 sites would take minutes; the refusal looks at no site.
            var exception = Assert.Throws<CommandLineException>(() =>
                PlayOverrides.Apply(PlayArguments.Parse(new[] { "player", "--", "--particles", "2000000000" }), new[] { simulation }));
            long most = SystemInfo.maxGraphicsBufferSize / FluidParticle.Stride;
            Assert.That(exception.Message,
                Does.StartWith("--particles 2000000000 does not fit 'Fluid': this device's buffers hold " + most));
            Assert.That(exception.Message, Does.Contain("The largest count that fits is " + most));
        }

        [Test]
        public void ParticlesForASceneWithoutLiquidAreRefused()
        {
            Assert.That(() => PlayOverrides.Apply(PlayArguments.Parse(new[] { "player", "--", "--particles", "100" }),
                new[] { simulation }),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("There is no liquid"));
        }

        private void Apply(string surface) =>
            PlayOverrides.Apply(PlayArguments.Parse(new[] { "player", "--", "--surface", surface }), new[] { simulation });
    }
}
