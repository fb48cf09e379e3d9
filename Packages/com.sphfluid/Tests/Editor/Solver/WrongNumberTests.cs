using System;
using System.Reflection;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Every constant that cannot be computed with is refused by its own name.</summary>
    public sealed class WrongNumberTests
    {
        private static readonly string[] PositiveSettings =
        {
            "Spacing", "SupportRadius", "RestDensity", "ParticleMass", "TimeStep",
        };

        private static readonly string[] OtherSettings = { "Viscosity" };

        private static readonly string[] PositiveOfThesis = { "Stiffness", "AccelerationLimit" };

        private static readonly string[] OtherOfThesis = { "WallStiffness", "WallDamping", "WallDistance" };

        private static readonly string[] PositiveInput =
        {
            "Spacing", "SupportRatio", "RestDensity", "SoundSpeedRatio", "MaxCompression", "TimeStepFraction",
            "WallDistanceRatio", "MinSpeed",
        };

        private static readonly string[] OtherInput =
        {
            "LiquidHeight", "LiquidDepth", "InitialSpeed", "KinematicViscosity", "ViscosityRatio", "WallStiffnessRatio", "WallDampingRatio",
        };

        [Test]
        public void SettingsThatMustBePositiveAre([ValueSource(nameof(PositiveSettings))] string name,
            [Values(0f, -1f, float.NaN, float.PositiveInfinity)] float bad) =>
                Refuses(name, () => Changed(Settings(), name, bad).Validate());

        [Test]
        public void SettingsThatMayBeZeroAreNotNegative([ValueSource(nameof(OtherSettings))] string name,
            [Values(-1f, float.NaN, float.PositiveInfinity)] float bad)
        {
            Refuses(name, () => Changed(Settings(), name, bad).Validate());
            Assert.That(() => Changed(Settings(), name, 0f).Validate(), Throws.Nothing);
        }

        [Test]
        public void TheThesisMethodsOwnMustBePositive([ValueSource(nameof(PositiveOfThesis))] string name,
            [Values(0f, -1f, float.NaN, float.PositiveInfinity)] float bad) =>
                Refuses(name, () => OfThesis(name, bad).Validate());

        [Test]
        public void TheThesisMethodsOwnThatMayBeZeroIsNotNegative([ValueSource(nameof(OtherOfThesis))] string name,
            [Values(-1f, float.NaN, float.PositiveInfinity)] float bad)
        {
            Refuses(name, () => OfThesis(name, bad).Validate());
            Assert.That(() => OfThesis(name, 0f).Validate(), Throws.Nothing);
        }

        [Test]
        public void TheStandardMethodsSpeedOfSoundMustBePositive([Values(0f, -1f, float.NaN, float.PositiveInfinity)] float bad)
        {
            FluidRuleInput input = Input();
            input.Method = FluidMethodKind.Standard;
            Refuses("SoundSpeed", () => FluidRules.Derive(input).WithSoundSpeed(bad).Validate());
        }

        [Test]
        public void SettingsWithoutTheMethodsOwnSayHowToDeriveThem()
        {
            var settings = new FluidSolverSettings
            {
                DomainSize = Vector3.one, Spacing = 0.05f, SupportRadius = 0.1f, RestDensity = 1000f, ParticleMass = 1f, TimeStep = 1e-3f,
            };
            Assert.That(() => settings.Validate(), Throws.ArgumentException.With.Message.Contains("FluidRules.Derive"));
            Assert.That(() => Settings().Own<StandardSettings>(), Throws.ArgumentException.With.Message.Contains("method Thesis"));
        }

        [Test]
        public void TheDomainHasASizeAlongEveryAxis([Values(0, 1, 2)] int axis, [Values(0f, -1f, float.NaN)] float bad)
        {
            FluidSolverSettings settings = Settings();
            settings.DomainSize[axis] = bad;
            Refuses("DomainSize", () => settings.Validate());
        }

        [Test]
        public void RulesRefuseWhatMustBePositive([ValueSource(nameof(PositiveInput))] string name,
            [Values(0f, -1f, float.NaN)] float bad) =>
                Refuses(name, () => FluidRules.Derive(Changed(Input(), name, bad)));

        [Test]
        public void RulesRefuseWhatMayNotBeNegative([ValueSource(nameof(OtherInput))] string name, [Values(-1f, float.NaN)] float bad) =>
            Refuses(name, () => FluidRules.Derive(Changed(Input(), name, bad)));

        private static void Refuses(string name, TestDelegate act)
        {
            var error = Assert.Throws<ArgumentException>(act);
            Assert.That(error.Message, Does.StartWith(name + " is "));
        }

        private static T Changed<T>(T value, string field, float number) where T : struct
        {
            object boxed = value;
            FieldInfo found = typeof(T).GetField(field);
            Assert.IsNotNull(found, field);
            found.SetValue(boxed, number);
            return (T)boxed;
        }

        private static FluidSolverSettings OfThesis(string name, float bad) =>
            Settings().WithOwn(Changed(Settings().Own<ThesisSettings>(), name, bad));

        private static FluidSolverSettings Settings() => TestSettings.ByRule(Vector3.one, 0.05f);

        private static FluidRuleInput Input()
        {
            FluidRuleInput input = FluidRuleInput.ThesisWater;
            input.DomainSize = Vector3.one;
            input.Spacing = 0.05f;
            input.LiquidHeight = 1f;
            input.LiquidDepth = 0.5f;
            return input;
        }
    }
}
