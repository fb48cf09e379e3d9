using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Cells over the domain: between walls the last may reach over, along periodic axes they divide it evenly.</summary>
    public sealed class FluidGridTests
    {
        [Test]
        public void PeriodicAxesAreDividedEvenly()
        {
            FluidSolverSettings settings = Settings(new Vector3(1f, 1f, 1f), 0.15f, true, FluidAxes.Y);
            FluidGrid grid = FluidGrid.For(settings);
            Assert.That(grid.Counts, Is.EqualTo(new Vector3Int(4, 3, 4)));
            Assert.That(grid.CellSize.x, Is.EqualTo(0.3f));
            Assert.That(grid.CellSize.y, Is.EqualTo(1f / 3f).Within(1e-7f));
            Assert.That(grid.CellSize.z, Is.EqualTo(0.3f));
        }

        [TestCase(true, 2)]
        [TestCase(false, 3)]
        public void TheLeastBoxIsThatOfTheSearch(bool octant, int cells)
        {
            const float radius = 0.1f;
            float least = cells * (octant ? 2f * radius : radius);
            Assert.That(FluidGrid.For(Settings(new Vector3(1f, 1f, least), radius, octant, FluidAxes.Z)).Counts.z, Is.EqualTo(cells));
            FluidSolverSettings shorter = Settings(new Vector3(1f, 1f, 0.99f * least), radius, octant, FluidAxes.Z);
            var error = Assert.Throws<ArgumentException>(() => FluidGrid.For(shorter));
            Assert.That(error.Message, Does.Contain("Z").And.Contain($"{least:G6} m or more").And.Contain("Enlarge the domain"));
            Assert.Throws<ArgumentException>(() => shorter.Validate());
            shorter.Boundaries.Periodic = FluidAxes.X;
            Assert.That(FluidGrid.For(shorter).Counts.z, Is.EqualTo(cells), "walls may be nearer");
        }

        [Test]
        public void WhereTheOctantIsTooWideTheOtherSearchIsNamed()
        {
            FluidSolverSettings settings = Settings(new Vector3(0.35f, 1f, 1f), 0.1f, true, FluidAxes.X);
            Assert.That(() => FluidGrid.For(settings), Throws.ArgumentException.With.Message.Contains("OctantSearch off"));
            settings.OctantSearch = false;
            Assert.That(FluidGrid.For(settings).Counts.x, Is.EqualTo(3));
        }

        private static FluidSolverSettings Settings(Vector3 domain, float radius, bool octant, FluidAxes periodic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(domain, 0.05f);
            settings.SupportRadius = radius;
            settings.OctantSearch = octant;
            settings.Boundaries.Periodic = periodic;
            return settings;
        }
    }
}
