using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Answers a question from a chart, or asks some and runs the answers; draws and writes what comes out.</summary>
    public sealed class ChooseSession : MeasuringSession
    {
        // An answer may change with what narrows the last one.
        private const int MostRounds = 6;

        private readonly ChooseArguments arguments;
        private readonly ChartData chart;
        private readonly Chooser chooser;
        private readonly FluidShaderSet shaders;
        private readonly ResultTable<ChartRow> runs; // null where none narrow
        private ChoiceAnswer answer; // null where some are verified

        /// <summary>Reads and fits the chart.</summary>
        /// <param name="arguments">The question.</param>
        /// <param name="shaders">The package's shaders, with which answers are run; not needed to answer.</param>
        /// <param name="progress">Where it says what it finds.</param>
        /// <exception cref="CommandLineException">There is no chart, no case is given, or the chart cannot answer.</exception>
        public ChooseSession(ChooseArguments arguments, FluidShaderSet shaders, SessionProgress progress) : base(arguments, progress)
        {
            this.arguments = arguments;
            this.shaders = shaders;
            bool verifies = arguments.Verifications > 0;
            if (arguments.Question.Case == null && !verifies)
            {
                throw new CommandLineException(
                    "Name the flow that yours is like with --case: a case, or a word such as splash, waves or pool. ./run choose --help " +
                    "lists them.");
            }
            string device = SystemInfo.graphicsDeviceName;
            chart = arguments.Chart != null ? ChartData.Read(arguments.Chart)
                : ChartData.Newest(Path.GetDirectoryName(Application.dataPath), device, arguments.Question.Case?.Name);
            if ((verifies || arguments.Narrows) && chart.Device != device)
            {
                throw new CommandLineException(
                    $"--{(verifies ? "verify" : "narrow")}: the chart in '{chart.Folder}' is of '{chart.Device}', and this is " +
                    $"'{device}', whose times it cannot tell.");
            }
            chooser = new Chooser(chart);
            bool narrows = arguments.Narrows && !verifies;
            if (narrows) runs = ResultTable<ChartRow>.Resume(ChartRow.Format, Folder, device, () => new ChartRow());
            answer = verifies ? null : Answer();
            IEnumerable<ResultFile> files = ChoiceScript.Files().Prepend(ChoiceRow.Format.File);
            Claim(verifies ? new[] { VerificationRow.Format.File } : runs != null ? files.Append(ChartRow.Format.File) : files);
        }

        /// <inheritdoc/>
        /// <exception cref="IncompleteException">All is written, but nothing that was measured keeps what was asked.</exception>
        public override bool Step()
        {
            if (base.Step()) return true;
            return answer == null || answer.Best != null ? false : throw new IncompleteException(
                "choose: nothing that was measured keeps what was asked; the nearest ways are above and in " +
                $"{Path.Combine(Folder, ChoiceRow.Format.FileName)}.");
        }

        private protected override string Unfinished => arguments.Verifications > 0 ? $"'{Folder}' holds every finished run."
            : "Nothing was written.";

        private ChoiceAnswer Answer() => runs == null || runs.Rows.Count == 0 ? chooser.Answer(arguments.Question)
            : new Chooser(chart.With(runs.Rows)).Answer(arguments.Question);

        private IEnumerator Measure(IReadOnlyList<ChartRun> missing)
        {
            var runner = new ChartRunner(shaders);
            foreach (ChartRun run in missing)
            {
                CaseResult result = null;
                yield return runner.Run(run, r => result = r);
                ChartRow[] rows = ChartRow.Of(run, result);
                runs.Add(rows);
                Progress.Say($"  {run}: {(rows[0].Failed ? rows[0].Reason : $"{rows[0].ErrorName} {CsvText.Text(rows[0].Error)}")}");
            }
        }

        private protected override IEnumerator Run()
        {
            if (arguments.Verifications > 0)
            {
                yield return new ChoiceVerification(chart, chooser, shaders, arguments, Progress).Run();
                yield break;
            }
            for (int round = 0; runs != null && round < MostRounds; round++)
            {
                List<ChartRun> missing = ChoiceText.Shown(answer).SelectMany(o => ChoiceNarrowing.Runs(o, answer.Question.Case)).ToList();
                if (missing.Count == 0) break;
                yield return Measure(missing);
                answer = Answer();
            }
            foreach (string line in ChoiceText.Lines(answer)) Progress.Say(line);
            ChoiceRow.Format.Write(Folder, ChoiceRow.Of(answer));
            string problem = GnuplotScript.Draw(Folder, new GnuplotScript[] { new ChoiceScript(answer) });
            Progress.Say(problem ?? $"{Path.Combine(Folder, "choose.png")}, choose.svg and {ChoiceRow.Format.FileName} are written.");
        }
    }
}
