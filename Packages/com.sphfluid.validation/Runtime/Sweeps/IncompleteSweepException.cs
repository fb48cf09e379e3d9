using System;

namespace SphFluid.Validation
{
    /// <summary>Merged results lack runs of the plan; the message says which. What there is has been written.</summary>
    public sealed class IncompleteSweepException : Exception
    {
        /// <summary>Makes the exception with its one-line message.</summary>
        public IncompleteSweepException(string message) : base(message)
        {
        }
    }
}
