using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What <c>leaks</c> plays and where it writes.</summary>
    public sealed class LeakArguments : MeasuringArguments
    {
        private readonly List<LeakSceneEntry> scenes = new List<LeakSceneEntry>();

        internal LeakArguments() : base("leaks", "Build/leaks")
        {
            AddChoice("--scene", "these scenes, each at rising speeds until it fails", "all", scenes, LeakSceneEntry.All, s => s.Name);
            AddFolder();
            AddShard();
        }

        /// <summary>The scenes.</summary>
        internal IReadOnlyList<LeakSceneEntry> Scenes => scenes;

        internal override string Command =>
            CommandOf(("--scene", scenes.SequenceEqual(LeakSceneEntry.All) ? null : scenes.Select(s => s.Name)));

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static LeakArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new LeakArguments();
            result.Read(commandLine);
            if (result.scenes.Count == 0) result.scenes.AddRange(LeakSceneEntry.All);
            return result;
        }
    }
}
