using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Charts of one case whose runs are made up, whole and in shards, below a folder of their own.</summary>
    internal sealed class ShardedCharts : IDisposable
    {
        private readonly string root = TestFolder.Fresh();

        /// <summary>What the sessions said.</summary>
        public List<string> Said { get; } = new List<string>();

        /// <summary>Runs that were done.</summary>
        public List<string> Done { get; } = new List<string>();

        /// <summary>The device of the next measurement.</summary>
        public string Device { get; set; } = "a device";

        /// <summary>The main error of a run.</summary>
        public Func<ChartRun, double> Error
        {
            get;
            set;
        } = run => 0.1 * run.Config.Spacing / run.Config.SupportRatio * (1.0 + 0.01 * run.Seed);

        /// <summary>Times are this much longer.</summary>
        public double Slowness { get; set; } = 1.0;

        /// <summary>A folder.</summary>
        public string Folder(string name) => Path.Combine(root, name);

        public string[] Lines(string name, string file) => File.ReadAllLines(Path.Combine(Folder(name), file));

        /// <summary>Measures to the end.</summary>
        public void Measure(string name, params string[] words)
        {
            using (ChartSession session = Create(name, words))
            {
                while (session.Step())
                {
                }
            }
        }

        /// <summary>Each of N shards in a folder of its number.</summary>
        public void MeasureAll(int shards)
        {
            for (int i = 1; i <= shards; i++) Measure(i.ToString(), "--shard", $"{i}/{shards}");
        }

        public ChartSession Create(string name, params string[] words)
        {
            ChartArguments arguments =
                ChartArguments.Parse(new[] { "--", "--quick", "--case", "ellipsoid", "--method", "standard", "--out",
                    Folder(name) }.Concat(words).ToArray());
            return new ChartSession(arguments, ChartPlan.Quick(arguments.Cases, arguments.Methods), Run,
                new SessionProgress(Said.Add, null), Device, new SessionRate(null));
        }

        /// <summary>Merges folders; flags begin with two dashes.</summary>
        public void Merge(string name, params string[] words)
        {
            string[] line = words.Select(w => w.StartsWith("--", StringComparison.Ordinal) ? w : Folder(w)).ToArray();
            using (var session =
                new MergeSession(MergeArguments.Parse(new[] { "--" }.Concat(line).Append("--out=" + Folder(name)).ToArray()),
                    new SessionProgress(Said.Add, null)))
            {
                while (session.Step())
                {
                }
            }
        }

        public void Dispose()
        {
            TestFolder.Delete(root);
        }

        private IEnumerator Run(ChartRun run, Action<CaseResult> hand)
        {
            yield return null;
            Done.Add(run.Key);
            CaseResult result = FlatCase.Result(Slowness * run.Config.Particles, Error(run));
            result.Errors = new[] { new CaseError(run.Config.Case.ErrorName, Error(run)), new CaseError("drift", -Error(run)) };
            hand(result);
        }
    }
}
