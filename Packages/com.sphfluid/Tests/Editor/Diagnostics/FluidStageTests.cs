using System.Linq;
using NUnit.Framework;
using SphFluid.Editor;

namespace SphFluid.Tests
{
    /// <summary>Every pass is in a stage of which times are shown, and every counter in the module of the Profiler.</summary>
    public sealed class FluidStageTests
    {
        [Test]
        public void EachPassIsInOneStage()
        {
            string[] staged = FluidStage.All.SelectMany(s => s.Passes).OrderBy(n => n, System.StringComparer.Ordinal).ToArray();
            Assert.That(staged, Is.Unique);
            Assert.That(staged, Is.EquivalentTo(TestAssets.Water.Shaders.ComputeShaders.Select(s => s.name)));
        }

        [Test]
        public void StagesHaveNamesOfTheirOwn() => Assert.That(FluidStage.All.Select(s => s.Name), Is.Unique);

        [Test]
        public void TheModuleOfTheProfilerHasEveryCounter()
        {
            Assert.That(FluidProfilerModule.Counters().Select(c => c.Name), Is.EqualTo(FluidProfiler.Names));
            Assert.That(FluidProfilerModule.Counters().Select(c => c.CategoryName), Has.All.EqualTo("SPH Fluid"));
            Assert.That(FluidProfiler.Names, Is.Unique);
            Assert.That(new FluidProfilerModule(), Is.Not.Null, "the Profiler window makes it so");
        }
    }
}
