using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The audit finds each kind of error that a neighbour search can make, and none where there is none.</summary>
    public sealed class NeighbourAuditTests
    {
        // On a line of 10 m: 0 and 1 near; 2 far; 3 near to 0 across the faces.
        private static readonly Vector3[] Line = { new Vector3(-4.5f, 0, 0), new Vector3(-3.7f, 0, 0), new Vector3(0, 0, 0),
            new Vector3(4.8f, 0, 0) };

        [Test]
        public void RightListsHaveNoErrors()
        {
            NeighbourAudit walls = Audit(Vector3.zero, new[] { 0, 1 }, new[] { 0 }, new int[0], new int[0]);
            Assert.That(walls.IsRight, Is.True);
            Assert.That(walls.Pairs, Is.EqualTo(2));
            NeighbourAudit periodic = Audit(new Vector3(10f, 0f, 0f), new[] { 1, 3 }, new[] { 0 }, new[] { 2 }, new[] { 0 });
            Assert.That(periodic.IsRight, Is.True);
            Assert.That(periodic.Pairs, Is.EqualTo(4));
            Assert.That(periodic.Findings, Is.Empty);
        }

        [Test]
        public void EachErrorIsListed()
        {
            NeighbourAudit audit = Audit(Vector3.zero, new[] { 1, 1, 2 }, new int[0], new[] { 0 }, new int[0]);
            Assert.That(audit.Missing.Single().ToString(), Does.StartWith("1 and 0 at 0.8"));
            Assert.That(audit.OneWay.Single().ToString(), Does.StartWith("0 and 1"));
            Assert.That(audit.Double.Single().Other, Is.EqualTo(1u));
            Assert.That(audit.Strangers.Select(e => e.Particle), Is.EquivalentTo(new uint[] { 0, 2 }));
            Assert.That(audit.Strangers[0].Distance, Is.EqualTo(4.5).Within(1e-6));
            Assert.That(audit.IsRight, Is.False);
            Assert.That(audit.Findings.Single().Failure, Is.EqualTo(FluidFailure.StaleGrid), "a pair met twice");
        }

        [Test]
        public void AOneWayPairIsAnAsymmetry() =>
            Assert.That(Audit(Vector3.zero, new[] { 1 }, new int[0], new int[0], new int[0]).Findings.Single().Failure,
                Is.EqualTo(FluidFailure.AsymmetricPairs));

        [Test]
        public void WrongListsAreRefused()
        {
            Assert.That(() => Audit(Vector3.zero, new[] { 4 }, new int[0], new int[0], new int[0]),
                Throws.ArgumentException.With.Message.Contains("particle 4"));
            Assert.That(() => Audit(Vector3.zero, new[] { 1 }), Throws.ArgumentException.With.Message.Contains("1 lists"));
        }

        [TestCase(1, true, FluidAxes.None)]
        [TestCase(255, false, FluidAxes.None)]
        [TestCase(256, true, FluidAxes.X)]
        [TestCase(257, false, FluidAxes.All)]
        [TestCase(1009, true, FluidAxes.All)]
        public void TheSearchesOfTheThesisAreRight(int count, bool octant, FluidAxes periodic)
        {
            var domain = new Vector3(0.47f, 0.41f, 0.53f);
            FluidSolverSettings settings = TestSettings.ByRule(domain, 0.025f);
            settings.OctantSearch = octant;
            settings.Boundaries.Periodic = periodic;
            FluidShaderSet shaders = FailureShaders.Create();
            try
            {
                using (var solver = new FluidSolver(settings, shaders, ParticleSets.Random(count, domain, 0f, count)))
                {
                    GpuTest.Run(cmd => solver.RecordNeighbourSetup(cmd));
                    NeighbourAudit audit = NeighbourAudit.Of(solver, FailureShaders.Audit());
                    Assert.That(audit.WrongCells, Is.Zero);
                    Assert.That(audit.IsRight, Is.True, string.Join("; ", audit.Missing.Take(3)));
                    Assert.That(audit.Pairs, count == 1 ? (NUnit.Framework.Constraints.IResolveConstraint)Is.Zero : Is.GreaterThan(count),
                        "there are pairs to compare");

                    solver.Particles.SetData(ParticleSets.Random(count, domain, 0f, count + 1));
                    NeighbourAudit stale = NeighbourAudit.Of(solver, FailureShaders.Audit());
                    Assert.That(stale.WrongCells, Is.GreaterThan(0), "a grid of other positions");
                    Assert.That(stale.Findings.Single().Failure, Is.EqualTo(FluidFailure.StaleGrid));
                }
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }

        private static NeighbourAudit Audit(Vector3 period, params int[][] found) =>
            NeighbourAudit.Of(Line, 1f, period, (IReadOnlyList<IReadOnlyList<int>>)found);
    }
}
