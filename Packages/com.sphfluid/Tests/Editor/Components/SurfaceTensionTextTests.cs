using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The profile says whether its surface tension acts.</summary>
    public sealed class SurfaceTensionTextTests
    {
        private FluidProfile profile;
        private FluidSimulation tank;

        [SetUp]
        public void SetUp()
        {
            profile =
                Object.Instantiate(AssetDatabase.LoadAssetAtPath<FluidProfile>("Packages/com.sphfluid/Runtime/Assets/WaterProfile.asset"));
            tank = new GameObject("Tank").AddComponent<FluidSimulation>();
            tank.Profile = profile;
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(tank.gameObject);
            Object.DestroyImmediate(profile);
        }

        [TestCase(0.025f,
            "'Tank': the surface tension of 0.073 N/m does not act at a spacing of 25 mm. It does at 2.7 mm and finer, the liquid's " +
            "capillary length, or with Tension At Any Spacing.")]
        [TestCase(0.002f, "'Tank': the surface tension of 0.073 N/m acts, with a contact angle of 30°.")]
        public void CoarseParticlesDoNotResolveIt(float spacing, string text)
        {
            Assert.That(SurfaceTensionText.Describe(tank, Constants(spacing, 0.2f)), Is.EqualTo(text));
        }

        [Test]
        public void WithoutGravityItActsWhereItIsAskedFor()
        {
            Assert.That(SurfaceTensionText.Describe(tank, Constants(0.025f, 0.2f, 0f)),
                Does.EndWith("It does at 2.7 mm and finer, the liquid's capillary length on Earth, or with Tension At Any Spacing."));
            profile.TensionAtAnySpacing = true;
            Assert.That(SurfaceTensionText.Describe(tank, Constants(0.025f, 0.2f, 0f)),
                Is.EqualTo("'Tank': the surface tension of 0.073 N/m acts, with a contact angle of 30°."));
        }

        [Test]
        public void WhereItSetsTheStepItSaysSo()
        {
            Assert.That(SurfaceTensionText.Describe(tank, Constants(0.0002f, 0.001f)),
                Does.Contain("acts, with a contact angle of 30°. It sets the time step of "));
        }

        [Test]
        public void AnotherMethodHasNone()
        {
            tank.Method = FluidMethodKind.Thesis;
            FluidSolverSettings constants = Constants(0.002f, 0.2f);
            Assert.That(SurfaceTensionText.Describe(tank, constants), Does.EndWith("does not act: the method Thesis has none."));
        }

        [TestCase(FluidMethodKind.Standard, "'Tank': the surface tension of 0.073 N/m acts, with a contact angle of 30°.")]
        [TestCase(FluidMethodKind.Robust, "'Tank': the surface tension of 0.073 N/m does not act: the method Robust has none.")]
        public void WithAutomaticTheMethodInUseDecides(FluidMethodKind inUse, string text)
        {
            tank.Method = inUse;
            FluidSolverSettings constants = Constants(0.002f, 0.2f);
            tank.Method = FluidMethodKind.Automatic;
            Assert.That(SurfaceTensionText.Describe(tank, constants), Is.EqualTo(text));
        }

        [Test]
        public void WithoutThereIsNothingToSay()
        {
            profile.SurfaceTension = 0f;
            Assert.That(SurfaceTensionText.Describe(tank, Constants(0.002f, 0.2f)), Is.Empty);
        }

        private FluidSolverSettings Constants(float spacing, float height, float gravity = 9.81f)
        {
            FluidRuleInput rules = profile.Spec.Rules;
            rules.Method = tank.Method;
            rules.Spacing = spacing;
            rules.Gravity = gravity * Vector3.down;
            rules.DomainSize = height * Vector3.one;
            rules.LiquidHeight = rules.LiquidDepth = height;
            return FluidRules.Derive(rules);
        }
    }
}
