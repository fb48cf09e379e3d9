using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The flags of a measurement. A subclass adds them in its constructor, in the order in which help and messages list them.
    /// </summary>
    public abstract class MeasuringArguments
    {
        private bool folderGiven;

        /// <param name="verb">Name of the measurement on the command line.</param>
        /// <param name="folder">Folder of the files without --out; null for none.</param>
        private protected MeasuringArguments(string verb, string folder)
        {
            Verb = verb;
            Options = new CommandLineOptions(verb);
            OutputFolder = folder;
        }

        /// <summary>Name of the measurement on the command line.</summary>
        internal string Verb { get; }

        /// <summary>
        /// What is measured, as the command line has it, without what changes no result: folder, slice and shard. Only the verb where
        /// nothing else is chosen.
        /// </summary>
        internal virtual string Command => Verb;

        /// <summary>The part of the runs that is done; null for all.</summary>
        internal Shard Shard { get; private set; }

        /// <summary>Whether only the short plan is measured.</summary>
        public bool Quick { get; private set; }

        /// <summary>Folder of the files.</summary>
        public string OutputFolder { get; private set; }

        /// <summary>Time after which it stops between two runs; null for all in one go.</summary>
        public TimeSpan? Slice { get; private protected set; }

        /// <summary>The flags.</summary>
        internal CommandLineOptions Options { get; }

        private protected void AddQuick(string text) => Options.Add("--quick", text, flag => Quick = flag.On());

        private protected void AddFolder(string absent = null) =>
            Options.Add("--out", "DIR", "folder for the output", absent ?? OutputFolder,
                flag => (OutputFolder, folderGiven) = (flag.Folder(), true));

        private protected void AddSlice(string absent) =>
            Options.Add("--slice", "MINUTES", "stops between two runs after this time", absent,
            flag => Slice = CommandLineWords.Minutes(flag.Name, flag.Value()));

        private protected void AddShard() =>
            Options.Add("--shard", "I/N", "only the runs of one of N machines, I from 1 to N; ./run merge puts their folders together",
                "all runs",
            flag => Shard = Shard.Parse(flag.Name, flag.Value()));

        /// <summary>See <see cref="Command"/>.</summary>
        /// <param name="chosen">Flags with what they choose; null for what holds without the flag.</param>
        private protected string CommandOf(params (string Flag, IEnumerable<string> Names)[] chosen) =>
            string.Join(" ", new[] { Verb }.Concat(Quick ? new[] { "--quick" } : Array.Empty<string>())
                .Concat(chosen.Where(c => c.Names != null).SelectMany(c => c.Names.Prepend(c.Flag))));

        /// <summary>Adds a flag that chooses by name, any number of times.</summary>
        private protected void AddChoice<T>(string name, string text, string absent, List<T> chosen, IReadOnlyList<T> known,
            Func<T, string> nameOf) =>
                Options.Add(name, "NAME...", text, absent, known.Select(nameOf).ToArray(), flag =>
                {
                    foreach (string word in flag.Values()) CommandLineWords.Choose(chosen, name, word, known, nameOf);
                });

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        private protected void Read(IReadOnlyList<string> commandLine)
        {
            Options.Read(commandLine);
            if (Shard != null && !folderGiven) OutputFolder += $"-{Shard.Index}-of-{Shard.Count}";
        }
    }
}
