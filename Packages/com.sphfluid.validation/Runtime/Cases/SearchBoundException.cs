using System;

namespace SphFluid.Validation
{
    /// <summary>A fit of a case ended at the bound of its search; the message names case, quantity, bound and cure.</summary>
    public sealed class SearchBoundException : Exception
    {
        /// <summary>With a message.</summary>
        public SearchBoundException(string message) : base(message)
        {
        }
    }
}
