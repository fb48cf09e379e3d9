using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Which surfaces <c>surfaces</c> makes of which states, and where it writes.</summary>
    public sealed class SurfaceArguments : MeasuringArguments
    {
        private readonly List<SurfaceStateEntry> states = new List<SurfaceStateEntry>();
        private readonly List<SurfaceVariantEntry> variants = new List<SurfaceVariantEntry>();

        internal SurfaceArguments() : base("surfaces", "Build/surfaces")
        {
            AddQuick("fewer variants, and fewer frames of liquid that moves");
            AddChoice("--state", "these states of liquid", "all", states, SurfaceStateEntry.All, s => s.Name);
            AddChoice("--variant", "these surfaces", "all", variants, SurfaceVariantEntry.All, v => v.Name);
            AddFolder();
            AddShard();
        }

        /// <summary>The states.</summary>
        internal IReadOnlyList<SurfaceStateEntry> States => states;

        /// <summary>The variants; the short plan has fewer.</summary>
        internal IReadOnlyList<SurfaceVariantEntry> Variants => variants;

        internal override string Command => CommandOf(
            ("--state", states.SequenceEqual(SurfaceStateEntry.All) ? null : states.Select(s => s.Name)),
            ("--variant", variants.SequenceEqual(DefaultVariants) ? null : variants.Select(v => v.Name)));

        private IEnumerable<SurfaceVariantEntry> DefaultVariants => SurfaceVariantEntry.All.Where(v => v.Quick || !Quick);

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static SurfaceArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new SurfaceArguments();
            result.Read(commandLine);
            if (result.states.Count == 0) result.states.AddRange(SurfaceStateEntry.All);
            if (result.variants.Count == 0) result.variants.AddRange(result.DefaultVariants);
            return result;
        }
    }
}
