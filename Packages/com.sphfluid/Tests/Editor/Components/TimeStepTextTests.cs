using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the inspector says about the constants before the start, in each time step mode.</summary>
    public sealed class TimeStepTextTests
    {
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            simulation = new GameObject("Fluid").AddComponent<FluidSimulation>();
            simulation.Method = FluidMethodKind.Thesis;
            simulation.ColliderLayers = 0;
            simulation.UseSceneGravity = false;
            simulation.Profile =
                Object.Instantiate(AssetDatabase.LoadAssetAtPath<FluidProfile>("Packages/com.sphfluid/Runtime/Assets/WaterProfile.asset"));
            simulation.Profile.SupportRatio = 2f;
            simulation.Profile.TimeStepFraction = 0.6f;
            var volume = new GameObject("Liquid").AddComponent<FluidVolume>();
            volume.transform.SetParent(simulation.transform, false);
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(simulation.Profile);
            Object.DestroyImmediate(simulation.gameObject);
        }

        [Test]
        public void AutomaticTakesSixTenthsOfTheLimitAtRest()
        {
            // v = √(2 · 9.81 · 0.75) = 3.836 m/s, c = 5 v = 19.18 m/s, k = 735.8; at rest 1.35 · 0.05/√k = 2.489 ms, at v 2.074 ms.
            TimeStepText text = Text();
            Assert.That(Value(text, "Speed of sound c"), Is.EqualTo("19.18 m/s"));
            Assert.That(Value(text, "Compression allowed"), Is.EqualTo("4 % at 3.84 m/s"));
            Assert.That(Value(text, "Viscosity ν"), Is.EqualTo("0.00959 m²/s"));
            Assert.That(Value(text, "Time step"), Is.EqualTo("1.49 ms"));
            Assert.That(Value(text, "Largest stable step"), Is.EqualTo("2.07 ms at 3.84 m/s"));
            Assert.That(Value(text, "Limited by"), Is.EqualTo("speed of sound"));
            Assert.That(Value(text, "Share in use"), Is.EqualTo("72 %"));
            Assert.That(text.Advice,
                Does.StartWith("The time step of 1.49 ms is 72 % of the largest stable one, 2.07 ms, which the speed of sound"));
        }

        [Test]
        public void AdaptiveTakesSixTenthsAtItsSpeed()
        {
            simulation.TimeStepMode = FluidTimeStepMode.Adaptive;
            Assert.That(Value(Text(), "Share in use"), Is.EqualTo("60 %"));
        }

        [Test]
        public void FixedIsComparedAsGiven()
        {
            simulation.TimeStepMode = FluidTimeStepMode.Fixed;
            simulation.FixedTimeStep = 0.001f;
            Assert.That(Value(Text(), "Share in use"), Is.EqualTo("48 %"));
        }

        [Test]
        public void NoConstantsWhereNothingCanStart()
        {
            simulation.Spacing = 0f;
            FluidSimulationChecks.Preview(simulation, out FluidSolverSettings? constants);
            Assert.That(constants, Is.Null);
        }

        private TimeStepText Text()
        {
            FluidSimulationChecks.Preview(simulation, out FluidSolverSettings? constants);
            Assert.That(constants, Is.Not.Null);
            return TimeStepText.Before(simulation, constants.Value);
        }

        private static string Value(TimeStepText text, string label) => text.Lines.Single(line => line.Label == label).Value;
    }
}
