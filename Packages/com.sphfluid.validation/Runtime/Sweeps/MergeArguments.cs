using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Which shards <c>merge</c> puts together and where it writes.</summary>
    public sealed class MergeArguments : MeasuringArguments
    {
        private readonly List<string> folders = new List<string>();

        internal MergeArguments() : base("merge", "Build/merge")
        {
            Options.AddWords(AddShardFolder);
            Options.Add("--errors-only", "leaves times out, so that shards of unlike or shared devices can be merged; no pictures",
                flag => ErrorsOnly = flag.On());
            AddFolder();
        }

        /// <summary>Folders of the shards.</summary>
        public IReadOnlyList<string> Folders => folders;

        /// <summary>Whether times are left out.</summary>
        public bool ErrorsOnly { get; private set; }

        /// <summary>Reads the command line of the process: folders and flags, behind a lone <c>--</c>.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, a value is missing or wrong, or a folder is not there or named
        /// twice.</exception>
        public static MergeArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new MergeArguments();
            result.Read(commandLine);
            return result;
        }

        private void AddShardFolder(string word)
        {
            if (!Directory.Exists(word))
            {
                throw new CommandLineException($"'{CommandLineWords.Shown(word)}' is no folder. Name the folders that --shard wrote to.");
            }
            if (folders.Any(f => Full(f) == Full(word)))
            {
                throw new CommandLineException($"'{CommandLineWords.Shown(word)}' is named twice.");
            }
            folders.Add(word);
        }

        internal static string Full(string folder) =>
            Path.GetFullPath(folder).TrimEnd(Path.DirectorySeparatorChar, Path.AltDirectorySeparatorChar);
    }
}
