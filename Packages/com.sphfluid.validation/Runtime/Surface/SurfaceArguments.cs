using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Which surfaces <c>surfaces</c> makes of which states, and where it writes.</summary>
    public sealed class SurfaceArguments : MeasuringArguments
    {
        readonly List<SurfaceStates> states = new List<SurfaceStates>();
        readonly List<SurfaceVariants> variants = new List<SurfaceVariants>();

        SurfaceArguments() : base("surfaces", "Build/surfaces")
        {
            AddQuick();
            AddChoice("--state", states, SurfaceStates.All, s => s.Name);
            AddChoice("--variant", variants, SurfaceVariants.All, v => v.Name);
            AddFolder();
        }

        /// <summary>The states.</summary>
        internal IReadOnlyList<SurfaceStates> States => states;

        /// <summary>The variants; the short plan has fewer.</summary>
        internal IReadOnlyList<SurfaceVariants> Variants => variants;

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static SurfaceArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new SurfaceArguments();
            result.Read(commandLine);
            if (result.states.Count == 0)
                result.states.AddRange(SurfaceStates.All);
            if (result.variants.Count == 0)
                result.variants.AddRange(SurfaceVariants.All.Where(v => v.Quick || !result.Quick));
            return result;
        }
    }
}
