using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The flags of a measurement. A subclass adds them in its constructor, in the order in which messages list them.</summary>
    public abstract class MeasuringArguments
    {
        readonly string verb;
        readonly List<(string Flag, Action<CommandLineFlag> Read)> options = new List<(string, Action<CommandLineFlag>)>();

        /// <param name="verb">Name of the measurement on the command line.</param>
        /// <param name="folder">Folder of the files without --out; null for none.</param>
        private protected MeasuringArguments(string verb, string folder)
        {
            this.verb = verb;
            OutputFolder = folder;
        }

        /// <summary>Whether only the short plan is measured.</summary>
        public bool Quick { get; private set; }

        /// <summary>Folder of the files.</summary>
        public string OutputFolder { get; private set; }

        /// <summary>Time after which it stops between two runs; null for all in one go.</summary>
        public TimeSpan? Slice { get; private protected set; }

        private protected void AddQuick() => Add("--quick", flag => Quick = flag.On());

        private protected void AddFolder() => Add("--out", flag => OutputFolder = flag.Folder());

        private protected void AddSlice() => Add("--slice", flag => Slice = CommandLineWords.Minutes(flag.Name, flag.Value()));

        /// <summary>Adds a flag that chooses by name, any number of times.</summary>
        private protected void AddChoice<T>(string name, List<T> chosen, IReadOnlyList<T> known, Func<T, string> nameOf) => Add(name, flag =>
        {
            foreach (string word in flag.Values())
                CommandLineWords.Choose(chosen, name, word, known, nameOf);
        });

        private protected void Add(string name, Action<CommandLineFlag> read) => options.Add((name, read));

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        private protected void Read(IReadOnlyList<string> commandLine) => CommandLineFlag.Read(
            commandLine, verb, options.Select(o => o.Flag).ToArray(), flag => options.Find(o => o.Flag == flag.Name).Read(flag));
    }
}
