using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Which surfaces <c>surfaces</c> makes of which states, and where it writes.</summary>
    public sealed class SurfaceArguments
    {
        static readonly string[] flags = { "--quick", "--state", "--variant", "--out" };

        readonly List<SurfaceStates> states = new List<SurfaceStates>();
        readonly List<SurfaceVariants> variants = new List<SurfaceVariants>();

        /// <summary>Fewer variants, and a third of the frames of liquid that moves.</summary>
        public bool Quick { get; private set; }

        /// <summary>Folder of the file.</summary>
        public string OutputFolder { get; private set; } = "Build/surfaces";

        /// <summary>The states.</summary>
        internal IReadOnlyList<SurfaceStates> States => states;

        /// <summary>The variants.</summary>
        internal IReadOnlyList<SurfaceVariants> Variants => variants;

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public static SurfaceArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new SurfaceArguments();
            CommandLineFlag.Read(commandLine, "surfaces", flags, result.Read);
            if (result.states.Count == 0)
                result.states.AddRange(SurfaceStates.All);
            if (result.variants.Count == 0)
                result.variants.AddRange(SurfaceVariants.All.Where(v => v.Quick || !result.Quick));
            return result;
        }

        void Read(CommandLineFlag flag)
        {
            switch (flag.Name)
            {
                case "--quick":
                    Quick = flag.On();
                    break;
                case "--state":
                    foreach (string name in flag.Values())
                        CommandLineWords.Choose(states, flag.Name, name, SurfaceStates.All, s => s.Name);
                    break;
                case "--variant":
                    foreach (string name in flag.Values())
                        CommandLineWords.Choose(variants, flag.Name, name, SurfaceVariants.All, v => v.Name);
                    break;
                default:
                    OutputFolder = flag.Folder();
                    break;
            }
        }
    }
}
