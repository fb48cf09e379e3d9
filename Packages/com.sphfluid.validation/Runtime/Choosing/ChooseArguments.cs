using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The question that <c>choose</c> is asked, and where it writes.</summary>
    public sealed class ChooseArguments : MeasuringArguments
    {
        private const int MostQuestions = 1000;

        private ChooseArguments() : base("choose", "Build/choose")
        {
            Options.Add("--case", "NAME", "a case, or a word for the flow: " + Words(), null, Names().ToArray(),
                flag => Question.Case = Find(flag.OneOf(Names().ToArray())));
            Options.Add("--error", "X%", "what the case's main error may be", "the least within --ms",
                flag => Question.Error = CommandLineWords.Share(flag.Name, flag.Value()));
            Options.Add("--ms", "MS", "GPU time that a frame may take", "the least with --error",
                flag => Question.Milliseconds = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--fps", "F", "frames a second", "60",
                flag => Question.FramesPerSecond = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--length", "M", "the liquid's length in metres, of the kind that the case has", "the case's own",
                flag => Question.Length = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--speed", "M/S", "the liquid's fastest speed", "as the case's, by length",
                flag => Question.Speed = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--volume", "M3", "the liquid's volume in cubic metres", "the case's, by length",
                flag => Question.Volume = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--compression", "X%", "compression by motion that is allowed", "4%",
                flag => Question.Compression = CommandLineWords.Share(flag.Name, flag.Value()));
            Options.Add("--chart", "DIR", "the chart that answers", "this device's newest", flag => Chart = flag.Value());
            Options.Add("--verify", "N", "asks N questions, runs the answers and compares", null,
                flag => Verifications = flag.Integer(1, MostQuestions));
            Options.Add("--narrow", "runs what narrows the answer's intervals where one is more than a factor of 4 wide, and asks again",
                flag => Narrows = flag.On());
            AddFolder();
        }

        /// <summary>The question; its case is null unless it was given.</summary>
        public ChoiceQuestion Question { get; } = new ChoiceQuestion();

        /// <summary>Folder of the chart; null: the newest of the device.</summary>
        public string Chart { get; private set; }

        /// <summary>Questions to ask and run; 0 for none.</summary>
        public int Verifications { get; private set; }

        /// <summary>Whether runs that narrow the answer's intervals are done.</summary>
        public bool Narrows { get; private set; }

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static ChooseArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new ChooseArguments();
            result.Read(commandLine);
            return result;
        }

        /// <summary>The flags, for help.</summary>
        internal static ChooseArguments Empty() => new ChooseArguments();

        /// <summary>The case of a name or word; null when there is none.</summary>
        internal static ValidationCase Find(string word) => Charted().FirstOrDefault(c => c.Name == word || c.Words.Contains(word));

        internal static IEnumerable<ValidationCase> Charted() => CaseCatalogue.All.Where(c => !c.IsGate);

        private static IEnumerable<string> Names() => Charted().SelectMany(c => c.Words.Prepend(c.Name));

        private static string Words() =>
            string.Join(", ", Charted().Where(c => c.Words.Count > 0).Select(c => $"{string.Join(" or ", c.Words)} ({c.Name})"));
    }
}
