using System;

namespace SphFluid.Validation
{
    /// <summary>A measurement that goes on a part at a time, once a frame of the engine, in play mode or in the Editor.</summary>
    public interface IValidationSession : IDisposable
    {
        /// <summary>Goes on; waits for the GPU by returning.</summary>
        /// <returns>False when all is measured and written.</returns>
        bool Step();
    }
}
