using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Tanks, box and jet: how they start, and coarse runs of the Standard method.</summary>
    public sealed class TankCaseTests
    {
        private static readonly CaseMethod standard = CaseMethod.Find("standard");

        private static IEnumerable<ValidationCase> Cases()
        {
            yield return new AcceleratedTankCase();
            yield return new PaddleCase();
            yield return new HeaveCase();
            yield return new JetCase();
            yield return new WallImpactCase();
            yield return new CapillaryDropCase();
        }

        [Test]
        public void SetupsCanBeRun([ValueSource(nameof(Cases))] ValidationCase flow, [Values(10)] int resolution,
            [Values(2.0, 2.5)] double supportRatio)
        {
            foreach (CaseMethod method in CaseMethod.All.Where(m => Runs(flow, m)))
            {
                CaseParameters parameters = WallCaseRig.Coarse(flow, method, resolution);
                parameters.SupportRatio = supportRatio;
                CaseSetup setup = flow.Build(parameters);
                setup.Settings.Validate();
                FluidSolver.CheckParticles(setup.Settings, setup.Particles);
                Assert.That(flow.CreateMetric(parameters, setup), Is.Not.Null);
            }
        }

        [Test]
        public void TheBoxStartsOnItsWaterAndFloatsByItsMass([Values(10, 13, 20)] int resolution)
        {
            CaseSetup setup = new HeaveCase().Build(WallCaseRig.Coarse(new HeaveCase(), standard, resolution));
            CaseBody box = setup.Bodies.Single();
            Bounds bounds = box.Mesh.Bounds;
            double bottom = box.Centre.y + bounds.min.y, dx = setup.Settings.Spacing;
            float[] under = setup.Particles.Where(p => Mathf.Abs(p.Position.x) < bounds.max.x).Select(p => p.Position.y).ToArray();
            Assert.That(bottom - under.Max(), Is.InRange(0.4 * dx, 0.6 * dx));
            Assert.That(setup.Particles.Count(p => Mathf.Abs(p.Position.x) < bounds.max.x + 0.4 * dx && p.Position.y > bottom), Is.Zero);
            int draught = Mathf.RoundToInt(0.4f * resolution);
            Assert.That(box.Mass, Is.EqualTo(setup.Settings.ParticleMass * 2 * draught * draught * setup.Settings.DomainSize.z / dx)
                .Within(0.01).Percent);
        }

        [Test]
        public void MethodsThatLackWhatACaseIsAboutAreNamed([ValueSource(nameof(Cases))] ValidationCase flow)
        {
            foreach (CaseMethod method in CaseMethod.All.Where(m => !Runs(flow, m)))
            {
                Assert.That(() => flow.Build(flow.Base(method)),
                    Throws.ArgumentException.With.Message.Contains(flow is HeaveCase ? "moves no bodies" : method.Name));
            }
        }

        [Test]
        public void MethodsFeelWallsAsTheSolverSays()
        {
            foreach (CaseMethod method in CaseMethod.All)
            {
                CaseSetup setup = new AcceleratedTankCase().Build(WallCaseRig.Coarse(new AcceleratedTankCase(), method, 8));
                using (var solver = new FluidSolver(setup.Settings, SurfaceTestScene.LoadShaders(), setup.Particles))
                    Assert.That(solver.MeasuresWallForces, Is.EqualTo(method.FeelsWalls), method.Name);
            }
        }

        [Test]
        public void ThePaddleIsTheFlumesEndAndGoesByItsStroke()
        {
            CaseSetup setup = new PaddleCase().Build(WallCaseRig.Coarse(new PaddleCase(), standard, 10));
            CaseBody paddle = setup.Bodies.Single();
            float face = paddle.Centre.x + paddle.Mesh.Bounds.max.x, nearest = setup.Particles.Min(p => p.Position.x);
            Assert.That(0.5f * setup.Settings.DomainSize.x - face, Is.EqualTo(4f).Within(1e-5f));
            Assert.That(nearest - face, Is.EqualTo(0.05f).Within(0.006f), "half a spacing");
            Assert.That(paddle.Path(0.0).x, Is.Zero);
            Assert.That(paddle.Path(System.Math.PI / PaddleCase.Frequency).x, Is.EqualTo(0.08f).Within(1e-5f));
        }

        [Test]
        public void TheTanksLevelSwings()
        {
            Assert.That(Run(new AcceleratedTankCase(), 8, out CaseMetric metric), Is.LessThan(0.35));
            Assert.That(WallCaseStates.Named(metric, "slope that it swings about over a/g − 1"), Is.Zero.Within(0.12));
            Assert.That(WallCaseStates.Named(metric, "first mode's period, T/T_exact − 1"), Is.Zero.Within(0.06));
        }

        [Test]
        public void TheJetPushesWithItsMomentum()
        {
            Assert.That(Run(new JetCase(), 5, out CaseMetric metric), Is.LessThan(0.07));
            Assert.That(WallCaseStates.Named(metric, "speed of the sheets over U − 1"), Is.Zero.Within(0.1));
            Assert.That(WallCaseStates.Named(metric, "force of the wall's strips over that by momentum − 1"), Is.Zero.Within(0.06));
            Assert.That(WallCaseStates.Named(metric, "pressure along the wall, RMS over ½ρU²"), Is.LessThan(0.3));
        }

        [Test]
        public void TheWallFeelsTheDamBreak()
        {
            Assert.That(Run(new WallImpactCase(), 10, out CaseMetric metric), Is.LessThan(0.45));
            Assert.That(WallCaseStates.Named(metric, "impulse on the gauges over the converged one − 1"), Is.Zero.Within(0.1));
            Assert.That(WallCaseStates.Named(metric, "water comes late, over √(H/g)"), Is.InRange(0.0, 0.3));
        }

        [Test]
        public void TheDropSwingsByItsTension()
        {
            Assert.That(Run(new CapillaryDropCase(), 4, out CaseMetric metric), Is.LessThan(0.25));
            Assert.That(WallCaseStates.Named(metric, "radius at the end over the start's − 1"), Is.Zero.Within(0.06));
        }

        private static bool Runs(ValidationCase flow, CaseMethod method) => flow is CapillaryDropCase ? method.HasTension
            : flow is WallImpactCase ? method.FeelsWalls : !(flow is HeaveCase && method.Name.StartsWith("thesis"));

        // The main error.
        private static double Run(ValidationCase flow, int resolution, out CaseMetric metric) =>
            WallCaseRig.MainError(flow, WallCaseRig.Coarse(flow, standard, resolution), out metric);
    }
}
