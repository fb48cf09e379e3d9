using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>What <c>leaks</c> plays and where it writes.</summary>
    public sealed class LeakArguments
    {
        static readonly string[] flags = { "--scene", "--out" };

        readonly List<LeakScenes> scenes = new List<LeakScenes>();

        /// <summary>The scenes.</summary>
        internal IReadOnlyList<LeakScenes> Scenes => scenes;

        /// <summary>Folder of the file.</summary>
        public string OutputFolder { get; private set; } = "Build/leaks";

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public static LeakArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new LeakArguments();
            int separator = CommandLineWords.Separator(commandLine);
            for (int i = separator + 1; i < commandLine.Count; i++)
            {
                string word = commandLine[i];
                int equals = word.StartsWith("--", StringComparison.Ordinal) ? word.IndexOf('=') : -1;
                string flag = equals > 0 ? word.Substring(0, equals) : word;
                string value = equals > 0 ? word.Substring(equals + 1) : null;
                if (flag == "--out")
                    result.OutputFolder = value ?? CommandLineWords.Value(commandLine, ref i);
                else if (flag == "--scene")
                    result.Choose(flag, value == null ? CommandLineWords.Values(commandLine, ref i) : CommandLineWords.List(flag, value));
                else if (separator >= 0)
                    throw new CommandLineException($"{word} is not a flag of leaks. Its flags are {string.Join(", ", flags)}.");
            }
            if (result.scenes.Count == 0)
                result.scenes.AddRange(LeakScenes.All);
            return result;
        }

        void Choose(string flag, IReadOnlyList<string> names)
        {
            foreach (string name in names)
                CommandLineWords.Choose(scenes, flag, name, LeakScenes.All, s => s.Name);
        }
    }
}
