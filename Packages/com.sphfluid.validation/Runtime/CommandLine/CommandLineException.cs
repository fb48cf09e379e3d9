using System;

namespace SphFluid.Validation
{
    /// <summary>A command line that cannot be carried out; the message is one line that names the flag and the cure.</summary>
    public sealed class CommandLineException : Exception
    {
        /// <summary>Makes the exception with its one-line message.</summary>
        public CommandLineException(string message) : base(message)
        {
        }
    }
}
