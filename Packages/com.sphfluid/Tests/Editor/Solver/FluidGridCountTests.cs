using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The number of cells that a check may ask for before the settings are known to be sound.</summary>
    public sealed class FluidGridCountTests
    {
        [TestCase(FluidAxes.X)]
        [TestCase(FluidAxes.Y)]
        [TestCase(FluidAxes.Z)]
        public void APeriodicAxisShorterThanACellIsCountedNotRefused(FluidAxes axis)
        {
            FluidSolverSettings settings = TestSettings.ByRule(new Vector3(1f, 1f, 1f), 0.05f);
            settings.OctantSearch = false;
            settings.SupportRadius = 0.1f;
            settings.Boundaries.Periodic = axis;
            settings.DomainSize[axis == FluidAxes.X ? 0 : axis == FluidAxes.Y ? 1 : 2] = 0.05f;
            Assert.That(FluidGrid.CountFor(settings, 2), Is.EqualTo(12.0 * 12.0 * 2.0));
            Assert.That(() => FluidGrid.For(settings), Throws.ArgumentException);
        }
    }
}
