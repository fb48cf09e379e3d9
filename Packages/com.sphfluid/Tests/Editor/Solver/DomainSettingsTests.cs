using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Faces and forces that cannot be: each is refused by name, with a cure.</summary>
    public sealed class DomainSettingsTests
    {
        private static readonly Vector3 Along = new Vector3(1f, 0f, 0f);

        [Test]
        public void WhatIsSoundPasses()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Z, NoSlip = true, LowY = Along, HighY = -Along };
            settings.BodyForce.RateSquared = new Vector3(0f, -3f, 0f);
            Assert.DoesNotThrow(() => settings.Validate());
        }

        [Test]
        public void AWallThatMovesThroughItselfIsRefused()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries = new FluidBoundaries { NoSlip = true, HighX = Along };
            Refused(settings, "HighX", "plane", "X component to zero");
        }

        [Test]
        public void AMovingWallThatOnlyPushesIsRefused()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries.LowZ = Along;
            Refused(settings, "LowZ", "Set Boundaries.Friction");
        }

        [Test]
        public void AMovingWallOfAPeriodicAxisIsRefused()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries = new FluidBoundaries { NoSlip = true, Periodic = FluidAxes.Y, LowY = Along };
            Refused(settings, "LowY", "Y is periodic", "to zero");
        }

        [TestCase(float.NaN)]
        [TestCase(float.NegativeInfinity)]
        public void WhatIsNoNumberIsRefused(float bad)
        {
            FluidSolverSettings walls = Settings();
            walls.Boundaries = new FluidBoundaries { NoSlip = true, HighZ = new Vector3(bad, 0f, 0f) };
            Refused(walls, "HighZ", "finite");
            FluidSolverSettings rate = Settings();
            rate.BodyForce.RateSquared.y = bad;
            Refused(rate, "RateSquared", "finite");
            FluidSolverSettings centre = Settings();
            centre.BodyForce.Centre.x = bad;
            Refused(centre, "centre", "finite");
        }

        [Test]
        public void ABodyForceAlongAPeriodicAxisIsRefused()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries.Periodic = FluidAxes.Z;
            settings.BodyForce.RateSquared = new Vector3(1f, 1f, 1f);
            Refused(settings, "RateSquared", "Z", "periodic");
        }

        [Test]
        public void AnAxisThatIsNoneIsRefused()
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries.Periodic = (FluidAxes)8;
            Refused(settings, "Periodic is 8", "X = 1");
        }

        [Test]
        public void PeriodicAxesCannotChangeWhileTheLiquidRunsButWallsAndForceCan()
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            try
            {
                using (var solver = new FluidSolver(Settings(), shaders, new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0) }))
                {
                    FluidSolverSettings other = Settings();
                    other.Boundaries.Periodic = FluidAxes.X;
                    Assert.That(() => solver.ApplySettings(other), Throws.ArgumentException.With.Message.Contains("Boundaries.Periodic"));
                    other = Settings();
                    other.Boundaries.NoSlip = true;
                    other.BodyForce.RateSquared = Vector3.one;
                    Assert.DoesNotThrow(() => solver.ApplySettings(other));
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, 1));
                    Assert.That(solver.Settings.Boundaries.NoSlip, Is.True);
                }
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(shaders);
            }
        }

        [TestCase(-0.1f)]
        [TestCase(1.5f)]
        [TestCase(float.NaN)]
        public void AFrictionOutOfRangeIsRefused(float friction)
        {
            FluidSolverSettings settings = Settings();
            settings.Boundaries.Friction = friction;
            Refused(settings, "Boundaries.Friction", "from 0 (free slip) to 1 (no slip)");
        }

        [Test]
        public void NoSlipIsFrictionOne()
        {
            var walls = new FluidBoundaries { NoSlip = true };
            Assert.That(walls.Friction, Is.EqualTo(1f));
            walls.Friction = 0.5f;
            Assert.That(walls.NoSlip, Is.False);
            walls.NoSlip = false;
            Assert.That(walls.IsDefault);
        }

        private static FluidSolverSettings Settings() => TestSettings.ByRule(Vector3.one, 0.05f);

        private static void Refused(FluidSolverSettings settings, params string[] words)
        {
            var error = Assert.Throws<ArgumentException>(() => settings.Validate());
            foreach (string word in words) Assert.That(error.Message, Does.Contain(word));
        }
    }
}
