using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What <c>chart</c> measures and where it writes.</summary>
    public sealed class ChartArguments
    {
        const double QuickMinutes = 9.0;

        static readonly string[] flags = { "--quick", "--case", "--method", "--out", "--slice" };

        readonly List<ValidationCase> cases = new List<ValidationCase>();
        readonly List<CaseMethod> methods = new List<CaseMethod>();

        /// <summary>Whether only the points of the short plan are measured.</summary>
        public bool Quick { get; private set; }

        /// <summary>The cases, none of them a gate.</summary>
        public IReadOnlyList<ValidationCase> Cases => cases;

        /// <summary>The methods.</summary>
        public IReadOnlyList<CaseMethod> Methods => methods;

        /// <summary>Folder of the files.</summary>
        public string OutputFolder { get; private set; } = "Build/chart";

        /// <summary>Time after which it stops between two runs; null for all in one go. A quick chart stops after nine minutes, however busy the machine.</summary>
        public TimeSpan? Slice { get; private set; }

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public static ChartArguments Parse(IReadOnlyList<string> commandLine) => Parse(commandLine, ValidationCases.All);

        internal static ChartArguments Parse(IReadOnlyList<string> commandLine, IReadOnlyList<ValidationCase> known)
        {
            var result = new ChartArguments();
            ValidationCase[] charted = known.Where(c => !c.IsGate).ToArray();
            CommandLineFlag.Read(commandLine, "chart", flags, flag => result.Read(flag, charted));
            result.FillIn(charted);
            return result;
        }

        void Read(CommandLineFlag flag, ValidationCase[] charted)
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
                        if (flag.Name == "--case")
                            CommandLineWords.Choose(cases, flag.Name, name, charted, c => c.Name);
                        else
                            CommandLineWords.Choose(methods, flag.Name, name, CaseMethod.All, m => m.Name);
                    }
                    break;
            }
        }

        void FillIn(ValidationCase[] charted)
        {
            if (cases.Count == 0)
                cases.AddRange(charted);
            if (methods.Count == 0)
                methods.AddRange(CaseMethod.All);
            if (Quick && !Slice.HasValue)
                Slice = TimeSpan.FromMinutes(QuickMinutes);
        }
    }
}
