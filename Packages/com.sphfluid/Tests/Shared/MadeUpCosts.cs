using System;

namespace SphFluid.Tests
{
    /// <summary>Costs of steps that were never measured, in the place of this device's until it is disposed.</summary>
    internal sealed class MadeUpCosts : IDisposable
    {
        private readonly StepCostTable table = new StepCostTable();

        public MadeUpCosts() => StepCosts.Use(table);

        /// <summary>Number of costs that are known.</summary>
        public int Count => table.Count;

        /// <summary>Sets what a step costs.</summary>
        public MadeUpCosts Set(FluidMethodKind method, double milliseconds, long particles = 64, bool inPlay = true, bool hasBodies = false,
            double supportRatio = 2.25, string variant = "")
        {
            table.Record(StepCostKey.Create(method, supportRatio, hasBodies, variant),
                new StepCost { Particles = particles, Milliseconds = milliseconds, InPlay = inPlay });
            return this;
        }

        public void Dispose() => StepCosts.Use(null);
    }
}
