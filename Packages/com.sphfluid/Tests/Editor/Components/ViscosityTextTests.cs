using NUnit.Framework;
using SphFluid.Editor;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The profile says which viscosity acts, and the liquids that the package ships are honest about theirs.</summary>
    public sealed class ViscosityTextTests
    {
        private const string Assets = "Packages/com.sphfluid/Runtime/Assets/";

        private FluidProfile profile;
        private GameObject scene;

        [SetUp]
        public void SetUp() => profile = Object.Instantiate(AssetDatabase.LoadAssetAtPath<FluidProfile>(Assets + "WaterProfile.asset"));

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(scene);
            Object.DestroyImmediate(profile);
        }

        // 5 √(2 · 9.81 m/s² · 1 m) = 22.15 m/s; a thousandth of it by 2.25 · 25 mm is 0.00125 m²/s. A tenth of that would need a tenth of
        // the spacing.
        [Test]
        public void LessThanTheLeastSaysWhatActsAndWhereTheValueWould()
        {
            FluidSimulation tank = Tank(0.025f);
            profile.KinematicViscosity = 1.246e-4f;
            Assert.That(ViscosityText.Describe(tank, Constants(tank)), Is.EqualTo(
                "'Tank': 0.0012 m²/s acts, the least of its method at a spacing of 25 mm. The 0.00012 m²/s that are set act at 2.5 mm " +
                "and finer."));
        }

        [Test]
        public void WaterNamesNoSpacingThatNobodyReaches()
        {
            FluidSimulation tank = Tank(0.025f);
            Assert.That(ViscosityText.Describe(tank, Constants(tank)),
                Is.EqualTo("'Tank': 0.0012 m²/s acts, the least of its method at a spacing of 25 mm."));
        }

        [Test]
        public void MoreThanTheLeastActsAsSet()
        {
            FluidSimulation tank = Tank(0.025f);
            profile.KinematicViscosity = 0.02f;
            Assert.That(ViscosityText.Describe(tank, Constants(tank)), Is.EqualTo("'Tank': 0.02 m²/s acts, as set."));
        }

        [Test]
        public void AViscosityThatSetsTheTimeStepSaysSo()
        {
            FluidSimulation tank = Tank(0.025f);
            profile.KinematicViscosity = 0.12f;
            Assert.That(ViscosityText.Describe(tank, Constants(tank)),
                Does.StartWith("'Tank': 0.12 m²/s acts, as set. It sets the time step of ").And.EndsWith(" ms."));
        }

        [TestCase(0.5f, "'Tank': 0.5 m²/s acts, as set. It is solved implicitly, in 8 iterations a step, and does not shorten the step.")]
        [TestCase(10f, "'Tank': 10 m²/s acts, as set. It is solved implicitly, in 31 iterations a step, and does not shorten the step.")]
        public void AViscosityThatIsSolvedForSaysWhatThatTakes(float viscosity, string text)
        {
            FluidSimulation tank = Tank(0.025f);
            profile.KinematicViscosity = viscosity;
            Assert.That(ViscosityText.Describe(tank, Constants(tank)), Is.EqualTo(text));
        }

        [Test]
        public void AProfileThatNothingUsesSaysWhereItActs()
        {
            Assert.That(ViscosityText.Unused(profile),
                Does.EndWith("the liquid is more viscous than set: 0.0005 m²/s at a spacing of 10 mm."));
            profile.KinematicViscosity = 0.01f;
            Assert.That(ViscosityText.Unused(profile),
                Does.EndWith("its viscosity acts as set at a spacing of 20 cm and finer; coarser liquid is more viscous."));
            profile.ViscosityRatio = 0f;
            Assert.That(ViscosityText.Unused(profile), Does.EndWith("its viscosity acts as set at any spacing."));
        }

        [Test]
        public void TheInspectorHasALineForEachSimulation()
        {
            Assert.That(ProfileViscosity.Find(profile), Does.StartWith("No simulation"));
            Tank(0.025f);
            string none = ProfileViscosity.Find(profile);
            Assert.That(none, Is.EqualTo("'Tank' cannot start; its inspector says why."), "it has no liquid");
            var liquid = new GameObject("Liquid").AddComponent<FluidVolume>();
            liquid.transform.SetParent(scene.transform, false);
            liquid.Size = new Vector3(0.5f, 0.5f, 0.5f);
            Assert.That(ProfileViscosity.Find(profile), Does.StartWith("'Tank': 0.0011 m²/s acts, the least"), "a fall of 0.75 m");
        }

        // 0.035 M R²/ν meets 0.675 R/(c/M + c/5), M = 0.976, at ν = 0.062 c R; the least viscosity is 0.001 c R.
        [Test]
        public void UpToSixtyTimesTheLeastTheStepsStayAsLong()
        {
            FluidSimulation tank = Tank(0.01f);
            float water = Constants(tank).TimeStep, least = Constants(tank).Viscosity / Constants(tank).RestDensity;
            profile.KinematicViscosity = 60f * least;
            Assert.That(Constants(tank).TimeStep, Is.EqualTo(water));
            profile.KinematicViscosity = 100f * least;
            Assert.That(Constants(tank).TimeStep, Is.EqualTo(0.62f * water).Within(0.01f * water));
            profile.KinematicViscosity = 128f * least;
            Assert.That(Constants(tank).TimeStep, Is.EqualTo(water), "implicit");
        }

        // Largest spacing at which the viscosity acts as typed, for a fall of 20 cm: 0.01 m ν / (0.001 · 9.905 m/s · 0.0225 m).
        [TestCase("OliveOilProfile", 911f, 9.2e-5f, 4.13e-3)]
        [TestCase("GlycerolProfile", 1258f, 7.4e-4f, 33.2e-3)]
        [TestCase("CastorOilProfile", 961f, 1.03e-3f, 46.2e-3)]
        [TestCase("BloodProfile", 1060f, 3.2e-6f, 143e-6)]
        [TestCase("LavaProfile", 2700f, 3.7e-2f, 1660e-3)]
        [TestCase("HoneyProfile", 1420f, 1.34e-2f, 601e-3)]
        [TestCase("MercuryProfile", 13534f, 1.13e-7f, 5.07e-6)]
        public void ALiquidOfThePackageActsUpToThisSpacing(string name, float density, float viscosity, double spacing)
        {
            var liquid = AssetDatabase.LoadAssetAtPath<FluidProfile>(Assets + name + ".asset");
            Assert.That(liquid.RestDensity, Is.EqualTo(density));
            Assert.That(liquid.KinematicViscosity, Is.EqualTo(viscosity).Within(1e-3f * viscosity));
            Assert.That(liquid.Shaders, Is.SameAs(profile.Shaders));
            Assert.That(ViscosityText.SpacingThatHonours(liquid, 0.2f), Is.EqualTo(spacing).Within(0.01 * spacing));
        }

        private FluidSimulation Tank(float spacing)
        {
            scene = new GameObject("Tank");
            var tank = scene.AddComponent<FluidSimulation>();
            tank.Profile = profile;
            tank.Spacing = spacing;
            return tank;
        }

        private FluidSolverSettings Constants(FluidSimulation tank) => FluidRules.Derive(Rules(tank));

        private FluidRuleInput Rules(FluidSimulation tank)
        {
            FluidRuleInput rules = profile.Spec.Rules;
            rules.Spacing = tank.Spacing;
            rules.DomainSize = Vector3.one;
            rules.LiquidHeight = rules.LiquidDepth = 1f;
            return rules;
        }
    }
}
