using System.Linq;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Profiles hold only numbers that can be computed with, and the package's assets are complete.</summary>
    public sealed class FluidProfileTests
    {
        private FluidProfile profile;

        [SetUp]
        public void Create() => profile = ScriptableObject.CreateInstance<FluidProfile>();

        [TearDown]
        public void Destroy() => Object.DestroyImmediate(profile);

        [Test]
        public void DefaultsAreWater()
        {
            FluidRuleInput water = FluidRuleInput.Water;
            Assert.That(profile.RestDensity, Is.EqualTo(water.RestDensity));
            Assert.That(profile.KinematicViscosity, Is.EqualTo(water.KinematicViscosity));
            Assert.That(profile.SupportRatio, Is.EqualTo(water.SupportRatio));
            Assert.That(profile.SoundSpeedRatio, Is.EqualTo(water.SoundSpeedRatio));
            Assert.That(profile.MaxCompression, Is.EqualTo(water.MaxCompression));
            Assert.That(profile.ViscosityRatio, Is.EqualTo(water.ViscosityRatio));
            Assert.That(profile.TimeStepFraction, Is.EqualTo(water.TimeStepFraction));
            Assert.That(profile.WallDistanceRatio, Is.EqualTo(water.WallDistanceRatio));
            Assert.That(profile.WallStiffnessRatio, Is.EqualTo(water.WallStiffnessRatio));
            Assert.That(profile.WallDampingRatio, Is.EqualTo(water.WallDampingRatio));
            Assert.That(profile.SoundSpeedMode, Is.EqualTo(FluidSoundSpeedMode.FollowsLiquid));
            Assert.That(profile.ThesisSwitches, Is.EqualTo(ThesisSwitches.Corrected));
            Assert.That(profile.Version, Is.EqualTo(1));
        }

        [Test]
        public void ValuesOutOfRangeAreClamped()
        {
            profile.RestDensity = -5f;
            Assert.That(profile.RestDensity, Is.EqualTo(1f));
            profile.TimeStepFraction = float.NaN;
            Assert.That(profile.TimeStepFraction, Is.EqualTo(0.75f));
            profile.SoundSpeedRatio = float.PositiveInfinity;
            Assert.That(profile.SoundSpeedRatio, Is.EqualTo(20f));
            profile.MaxParticles = 0;
            Assert.That(profile.MaxParticles, Is.EqualTo(1));
        }

        [TestCase("Runtime/Assets/WaterProfile", 2.25f)]
        [TestCase("Runtime/Assets/FastWaterProfile", 2.25f)]
        [TestCase("Thesis/Assets/ThesisWaterProfile", 2f)]
        public void ShippedAssetsAreComplete(string path, float supportRatio)
        {
            var water = AssetDatabase.LoadAssetAtPath<FluidProfile>($"Packages/com.sphfluid/{path}.asset");
            Assert.That(water, Is.Not.Null);
            Assert.That(water.Shaders, Is.Not.Null);
            Assert.That(PackageShaders.Missing(water.Shaders), Is.Empty);
            Assert.That(water.RestDensity, Is.EqualTo(1000f));
            Assert.That(water.SupportRatio, Is.EqualTo(supportRatio));
            Assert.That(water.ThesisSwitches, Is.EqualTo(ThesisSwitches.Corrected));
            Assert.That(water.Version, Is.EqualTo(1));
        }

        [Test]
        public void ThePackagesSetHasEveryComputeShaderOfTheGroupsAndNoOther()
        {
            var named = PackageShaders.Groups.SelectMany(g => g.Shaders).ToArray();
            FluidShaderSet package = TestShaders.PackageSet;
            var held = package.ComputeShaders.Select(s => s.name).Concat(package.Shaders.Select(s => s.name));
            Assert.That(held, Is.EquivalentTo(named));
        }

        [Test]
        public void ShaderSetNamesWhatIsMissing()
        {
            var set = ScriptableObject.CreateInstance<FluidShaderSet>();
            try
            {
                Assert.That(set.Missing(FluidMethods.Get(FluidMethodKind.Thesis).Shaders.Shaders),
                    Is.EqualTo(FluidMethods.Get(FluidMethodKind.Thesis).Shaders.Shaders).And.Contain("BitonicSort"));
                set.ComputeShaders = new[] { TestShaders.Load("Thesis/Shaders/Solver/BitonicSort.compute"), null };
                Assert.That(set.Missing(FluidMethods.Get(FluidMethodKind.Thesis).Shaders.Shaders),
                    Does.Contain("CalculateNewPosition").And.Not.Contain("BitonicSort"));
                Assert.That(set.Missing(ShaderGroup.Drawing.Shaders), Does.Contain("SPH Fluid/Particles"));
            }
            finally
            {
                Object.DestroyImmediate(set);
            }
        }
    }
}
