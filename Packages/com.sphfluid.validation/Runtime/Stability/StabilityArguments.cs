using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What <c>stability</c> measures and where it writes.</summary>
    public sealed class StabilityArguments : MeasuringArguments
    {
        private readonly List<StabilityMap> maps = new List<StabilityMap>();
        private readonly List<CaseMethod> methods = new List<CaseMethod>();

        internal StabilityArguments() : base("stability", "Build/stability")
        {
            AddQuick("fewer points: a quarter of an hour on two CPU cores");
            AddChoice("--map", "these maps", "all, and the borders", maps, StabilityMap.All, m => m.Name);
            AddChoice("--method", "these methods", "all; not thesis-printed and standard-corrected with --quick", methods, CaseMethod.All, m => m.Name);
            AddFolder();
            AddSlice("none");
            AddShard();
        }

        /// <summary>The maps.</summary>
        public IReadOnlyList<StabilityMap> Maps => maps;

        /// <summary>The methods; the short plan has those for reference on request.</summary>
        public IReadOnlyList<CaseMethod> Methods => methods;

        /// <summary>Whether the borders are bisected: in every session that draws all maps.</summary>
        public bool Limits { get; private set; }

        internal override string Command => CommandOf(
            ("--map", Limits ? null : Maps.Select(m => m.Name)),
            ("--method", Methods.SequenceEqual(DefaultMethods) ? null : Methods.Select(m => m.Name)));

        private IEnumerable<CaseMethod> DefaultMethods => CaseMethod.All.Where(m => !Quick || !m.IsReference);

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static StabilityArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new StabilityArguments();
            result.Read(commandLine);
            result.Limits = result.maps.Count == 0;
            if (result.maps.Count == 0) result.maps.AddRange(StabilityMap.All);
            if (result.methods.Count == 0) result.methods.AddRange(result.DefaultMethods);
            return result;
        }
    }
}
