using NUnit.Framework;
using SphFluid.Editor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the inspector says about the domain, and whether the cells it counts are those that a solver makes.</summary>
    public sealed class DomainTextTests
    {
        [Test]
        public void CellsBeforeTheStartAreThoseOfTheBudget()
        {
            // 1 m over R = 0.1 m is 10 cells, 0.55 m is 6, and a border at both ends: 12 · 8 · 12.
            FluidSolverSettings settings = BodyRig.Water(new Vector3(1f, 0.55f, 1f), 0.05f, 0.3f);
            settings.SupportRadius = 0.1f;
            string most = CellChecks.Most(settings.Method).ToString("N0", System.Globalization.CultureInfo.InvariantCulture);
            Assert.That(DomainText.Cells(settings), Is.EqualTo(("Cells", $"1,152 of {most} at most")));
        }

        [TestCase(FluidMethodKind.Standard)]
        [TestCase(FluidMethodKind.Thesis)]
        public void CountedCellsAreTheSolvers(FluidMethodKind method)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.7f, 0.5f, 0.31f), 0.05f, 0.3f);
            settings.Method = method;
            settings.Boundaries.Periodic = FluidAxes.X;
            var shaders = TestShaders.CreateSet();
            try
            {
                using (var solver = new FluidSolver(settings, shaders, new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0) }))
                    Assert.That(CellChecks.Needed(settings), Is.EqualTo(solver.CellCount));
            }
            finally
            {
                Object.DestroyImmediate(shaders);
            }
        }

        [Test]
        public void ParticlesThatLeftAreSaid()
        {
            Assert.That(DomainText.Particles(12000, 0), Is.EqualTo("12,000"));
            Assert.That(DomainText.Particles(9000, 3000), Is.EqualTo("9,000; 3,000 have left"));
        }
    }
}
