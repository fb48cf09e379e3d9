using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What a shard has measured, as its folder holds it.</summary>
    internal sealed class ShardResults
    {
        private readonly Dictionary<string, List<string>> lines = new Dictionary<string, List<string>>();
        private HashSet<string> finished;

        private ShardResults(string folder) => Folder = folder;

        /// <summary>The folder, as it was named.</summary>
        public string Folder { get; }

        /// <summary>What it is a part of.</summary>
        public ShardManifest Manifest { get; private set; }

        /// <summary>The verb.</summary>
        public ShardedVerb Verb { get; private set; }

        /// <summary>All runs of the sweep.</summary>
        public SweepPlan Plan { get; private set; }

        /// <summary>Runs that have lines but were stopped before their end.</summary>
        public IEnumerable<string> Stopped => lines.Keys.Where(k => !finished.Contains(k));

        /// <summary>Reads a folder.</summary>
        /// <exception cref="CommandLineException">It holds no shard, or a broken one; the message names the folder.</exception>
        public static ShardResults Read(string folder)
        {
            var result = new ShardResults(folder);
            try
            {
                result.Load();
                return result;
            }
            catch (Exception exception) when (exception is FormatException || exception is IOException ||
                exception is UnauthorizedAccessException)
            {
                throw new CommandLineException($"'{CommandLineWords.Shown(folder)}' cannot be merged: {exception.Message.TrimEnd('.')}.");
            }
        }

        /// <summary>Whether the shard has finished a run.</summary>
        public bool Has(string run) => finished.Contains(run) && lines.ContainsKey(run);

        /// <summary>The lines of a run.</summary>
        public IReadOnlyList<string> LinesOf(string run) => lines[run];

        private void Load()
        {
            Manifest = ShardManifest.Find(Folder) ??
                throw new FormatException(
                    $"it has no {ShardManifest.Format.FileName} of this version, as a measurement with --shard writes it");
            Verb = ShardedVerb.Find(Manifest.Verb) ??
                throw new FormatException($"this version has no shards of '{CommandLineWords.Shown(Manifest.Verb)}'");
            Plan = SweepPlan.Read(Folder);
            if (Plan.Hash != Manifest.Plan || Plan.Runs.Count != Manifest.Runs)
            {
                throw new FormatException(
                    $"its {SweepPlan.Format.FileName} was changed: it is not the plan {Manifest.Plan} with {Manifest.Runs} runs");
            }
            finished =
                new HashSet<string>(ShardRunRow.Format.ReadAll(Path.Combine(Folder, ShardRunRow.Format.FileName), () => new ShardRunRow())
                    .Select(r => r.Run));
            var planned = new HashSet<string>(Plan.Runs.Select(r => r.Key));
            foreach (ShardedTable table in Verb.Tables) Load(table, planned);
        }

        // A shard without runs for a table has none.
        private void Load(ShardedTable table, HashSet<string> planned)
        {
            string file = Path.Combine(Folder, table.File.Name);
            if (!File.Exists(file)) return;
            string[] all = File.ReadAllLines(file);
            if (all.Length == 0 || all[0] != table.File.FirstLine)
            {
                throw new FormatException($"its {table.File.Name} does not have the columns of this version");
            }
            for (int i = 1; i < all.Length; i++)
            {
                string run = table.KeyOf(all[i]);
                if (run == null) throw new FormatException($"its {table.File.Name} has a broken line {i + 1}");
                if (!planned.Contains(run))
                {
                    throw new FormatException($"line {i + 1} of its {table.File.Name} is of a run that is not in its plan");
                }
                if (!lines.TryGetValue(run, out List<string> own)) lines.Add(run, own = new List<string>());
                own.Add(all[i]);
            }
        }
    }
}
