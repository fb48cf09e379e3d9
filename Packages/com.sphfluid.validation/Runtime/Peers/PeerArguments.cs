using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Which cases <c>peers</c> gives to PySPH, and where it writes.</summary>
    public sealed class PeerArguments : MeasuringArguments
    {
        private readonly List<PeerCase> cases = new List<PeerCase>();

        internal PeerArguments() : base("peers", "Build/peers")
        {
            AddQuick("each case once, at half of its resolution");
            AddChoice("--case", "these cases", "all of these", cases, PeerCase.All, c => c.Case.Name);
            Options.Add("--python", "FILE", "the Python that has PySPH", PySph.DefaultPython, flag => Python = flag.Value());
            Options.Add("--chart", "DIR", "the chart with whose methods it is compared", "this device's newest",
                flag => Chart = flag.Value());
            AddFolder();
            AddSlice("none");
        }

        /// <summary>The cases.</summary>
        internal IReadOnlyList<PeerCase> Cases => cases;

        /// <summary>The Python that has PySPH.</summary>
        public string Python { get; private set; } = PySph.DefaultPython;

        /// <summary>Folder of the chart with whose methods it is compared; null: the newest of the device.</summary>
        public string Chart { get; private set; }

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static PeerArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new PeerArguments();
            result.Read(commandLine);
            if (result.cases.Count == 0) result.cases.AddRange(PeerCase.All);
            return result;
        }
    }
}
