using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What <c>stability</c> measures and where it writes.</summary>
    public sealed class StabilityArguments
    {
        static readonly string[] flags = { "--quick", "--map", "--method", "--out", "--slice" };

        readonly List<StabilityMap> maps = new List<StabilityMap>();
        readonly List<CaseMethod> methods = new List<CaseMethod>();

        /// <summary>Whether only the cells of the short plan are run.</summary>
        public bool Quick { get; private set; }

        /// <summary>The maps.</summary>
        public IReadOnlyList<StabilityMap> Maps => maps;

        /// <summary>The methods; without the printed one where the short plan is not told.</summary>
        public IReadOnlyList<CaseMethod> Methods => methods;

        /// <summary>Whether the borders are bisected: in every session that draws all maps.</summary>
        public bool Limits { get; private set; }

        /// <summary>Folder of the files.</summary>
        public string OutputFolder { get; private set; } = "Build/stability";

        /// <summary>Time after which it stops between two runs; null for all in one go.</summary>
        public TimeSpan? Slice { get; private set; }

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public static StabilityArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new StabilityArguments();
            CommandLineFlag.Read(commandLine, "stability", flags, result.Read);
            result.FillIn();
            return result;
        }

        void Read(CommandLineFlag flag)
        {
            switch (flag.Name)
            {
                case "--quick":
                    Quick = flag.On();
                    break;
                case "--out":
                    OutputFolder = flag.Folder();
                    break;
                case "--slice":
                    Slice = CommandLineWords.Minutes(flag.Name, flag.Value());
                    break;
                default:
                    foreach (string name in flag.Values())
                    {
                        if (flag.Name == "--map")
                            CommandLineWords.Choose(maps, flag.Name, name, StabilityMaps.All, m => m.Name);
                        else
                            CommandLineWords.Choose(methods, flag.Name, name, CaseMethod.All, m => m.Name);
                    }
                    break;
            }
        }

        void FillIn()
        {
            Limits = maps.Count == 0;
            if (maps.Count == 0)
                maps.AddRange(StabilityMaps.All);
            if (methods.Count == 0)
                methods.AddRange(CaseMethod.All.Where(m => !Quick || m.Kind != FluidMethodKind.ThesisPrinted));
        }
    }
}
