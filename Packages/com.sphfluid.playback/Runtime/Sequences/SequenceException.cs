using System;

namespace SphFluid
{
    /// <summary>A folder or a file of a sequence cannot be played.</summary>
    internal sealed class SequenceException : Exception
    {
        public const string Again = "Write the file anew, or copy it again from where it was made.";

        /// <param name="text">What is wrong, as the rest of a sentence that begins with the name of the folder or file, without a full
        /// stop.</param>
        /// <param name="cure">What to do, as a full sentence.</param>
        public SequenceException(string text, string cure = Again) : base(text) => Cure = cure;

        /// <summary>What to do about it.</summary>
        public string Cure { get; }
    }
}
