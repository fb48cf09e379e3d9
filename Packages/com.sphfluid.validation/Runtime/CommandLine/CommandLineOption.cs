using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A flag of a verb as its help shows it. The parser reads flags by the same object, so that none is without help.</summary>
    public sealed class CommandLineOption
    {
        internal CommandLineOption(string name, string value, string text, string absent, IReadOnlyList<string> choices,
            Action<CommandLineFlag> read)
        {
            Name = name;
            Value = value;
            Text = text;
            Absent = absent;
            Choices = choices ?? Array.Empty<string>();
            Read = read;
        }

        /// <summary>The flag, for instance "--out".</summary>
        public string Name { get; }

        /// <summary>What stands for its value, for instance "DIR"; null for a flag without one.</summary>
        public string Value { get; }

        /// <summary>What it does, in a few words.</summary>
        public string Text { get; }

        /// <summary>What holds without it; null where the text says it.</summary>
        public string Absent { get; }

        /// <summary>The only values that it takes; empty for any.</summary>
        public IReadOnlyList<string> Choices { get; }

        internal Action<CommandLineFlag> Read { get; }
    }
}
