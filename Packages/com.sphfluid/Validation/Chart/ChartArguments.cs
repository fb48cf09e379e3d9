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
            int separator = CommandLineWords.Separator(commandLine);
            for (int i = separator + 1; i < commandLine.Count; i++)
            {
                string word = commandLine[i];
                int equals = word.StartsWith("--", StringComparison.Ordinal) ? word.IndexOf('=') : -1;
                string flag = equals > 0 ? word.Substring(0, equals) : word;
                string value = equals > 0 ? word.Substring(equals + 1) : null;
                if (Array.IndexOf(flags, flag) < 0)
                {
                    if (separator >= 0)
                        throw new CommandLineException($"{word} is not a flag of chart. Its flags are {string.Join(", ", flags)}.");
                }
                else if (flag == "--quick")
                {
                    result.Quick = value == null ? true : throw new CommandLineException($"{flag} takes no value.");
                }
                else if (flag == "--case" || flag == "--method")
                {
                    result.ReadNames(flag, value == null ? CommandLineWords.Values(commandLine, ref i) : CommandLineWords.List(flag, value), charted);
                }
                else
                {
                    result.Read(flag, value ?? CommandLineWords.Value(commandLine, ref i));
                }
            }
            result.FillIn(charted);
            return result;
        }

        void ReadNames(string flag, IReadOnlyList<string> names, ValidationCase[] charted)
        {
            foreach (string name in names)
            {
                if (flag == "--case")
                    CommandLineWords.Choose(cases, flag, name, charted, c => c.Name);
                else
                    CommandLineWords.Choose(methods, flag, name, CaseMethod.All, m => m.Name);
            }
        }

        void Read(string flag, string value)
        {
            if (flag == "--out")
            {
                OutputFolder = value;
                return;
            }
            Slice = CommandLineWords.Minutes(flag, value);
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
