using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A stepper of a method whose number of particles changes: <see cref="FluidMethodFeatures.ChangingCount"/>.</summary>
    internal interface IExchangingStepper
    {
        /// <summary>Makes slots for more particles.</summary>
        /// <param name="cmd">Command buffer, after the motion of a step that does not keep the order; null where particles are loaded
        /// next.</param>
        /// <param name="capacity">Number of slots.</param>
        void Reserve(CommandBuffer cmd, int capacity);

        /// <summary>Records the particles that drains remove, before the motion of a step that does not keep the order.</summary>
        void RecordDrains(CommandBuffer cmd, in DrainBatch drains);

        /// <summary>Records births, after the motion of a step that does not keep the order.</summary>
        void RecordBirths(CommandBuffer cmd, in BirthBatch births);
    }
}
