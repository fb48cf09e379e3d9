using System;

namespace SphFluid.Validation
{
    /// <summary>The results lack something that was asked for; the message says what. What there is has been written.</summary>
    public sealed class IncompleteException : Exception
    {
        /// <summary>Makes the exception with its one-line message.</summary>
        public IncompleteException(string message) : base(message)
        {
        }
    }
}
