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
            CommandLineFlag.Read(commandLine, "leaks", flags, result.Read);
            if (result.scenes.Count == 0)
                result.scenes.AddRange(LeakScenes.All);
            return result;
        }

        void Read(CommandLineFlag flag)
        {
            if (flag.Name == "--out")
            {
                OutputFolder = flag.Folder();
                return;
            }
            foreach (string name in flag.Values())
                CommandLineWords.Choose(scenes, flag.Name, name, LeakScenes.All, s => s.Name);
        }
    }
}
