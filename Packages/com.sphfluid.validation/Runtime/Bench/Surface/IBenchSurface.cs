using System;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>A surface that is measured: field, mesh and drawing.</summary>
    internal interface IBenchSurface : IDisposable
    {
        /// <summary>What its last frame made.</summary>
        BenchSurfaceFacts Facts { get; }

        /// <summary>Whether its buffers hold the whole mesh; until then trial frames show how much it needs.</summary>
        bool HasCapacity { get; }

        /// <summary>Records a frame that is not measured.</summary>
        void RecordTrial(CommandBuffer cmd, FluidSolver solver);

        /// <summary>Grows to what the trial frame, now executed, needed. Waits for the GPU.</summary>
        void TakeTrial();

        /// <summary>Records everything from sorted particles to the picture.</summary>
        void Record(CommandBuffer cmd, FluidSolver solver, BenchDrawing drawing);
    }
}
