using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The flags of a verb, in the order in which help and messages list them.</summary>
    internal sealed class CommandLineOptions : IEnumerable<CommandLineOption>
    {
        private readonly string verb;
        private readonly List<CommandLineOption> options = new List<CommandLineOption>();
        private Action<string> takeWord; // null where there are only flags

        /// <param name="verb">For messages.</param>
        public CommandLineOptions(string verb) => this.verb = verb;

        /// <summary>Adds a flag with a value.</summary>
        public void Add(string name, string value, string text, string absent, Action<CommandLineFlag> read) =>
            Add(name, value, text, absent, null, read);

        /// <summary>Adds a flag with a value that is one of some words.</summary>
        public void Add(string name, string value, string text, string absent, IReadOnlyList<string> choices,
            Action<CommandLineFlag> read) =>
                options.Add(new CommandLineOption(name, value, text, absent, choices, read));

        /// <summary>Adds a flag without a value.</summary>
        public void Add(string name, string text, Action<CommandLineFlag> read) => Add(name, null, text, null, null, read);

        /// <summary>Lets words stand that are neither flags nor their values; only behind a lone <c>--</c>.</summary>
        public void AddWords(Action<string> take) => takeWord = take;

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public void Read(IReadOnlyList<string> commandLine) =>
            CommandLineFlag.Read(commandLine, verb, options.Select(o => o.Name).ToArray(),
                flag => options.Find(o => o.Name == flag.Name).Read(flag), takeWord);

        /// <inheritdoc/>
        public IEnumerator<CommandLineOption> GetEnumerator() => options.GetEnumerator();

        IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();
    }
}
