using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Shards of one sweep, checked against each other and put together in the order of the plan.</summary>
    internal sealed class SweepMerge
    {
        private readonly bool errorsOnly;
        private readonly Dictionary<string, ShardResults> owners = new Dictionary<string, ShardResults>();

        /// <summary>Checks shards.</summary>
        /// <param name="shards">At least one.</param>
        /// <param name="errorsOnly">Whether times are left out, so that devices may differ.</param>
        /// <exception cref="CommandLineException">They are not of one sweep, or two have unequal results of a run.</exception>
        public SweepMerge(IEnumerable<ShardResults> shards, bool errorsOnly)
        {
            this.errorsOnly = errorsOnly;
            Shards = shards.OrderBy(s => s.Manifest.Shard.Index).ToList();
            foreach (ShardResults other in Shards.Skip(1)) Refuse(Shards[0], other);
            Runs = Shards[0].Plan.Runs.Where(r => !errorsOnly || !Verb.Tables.Any(t => t.IsOfTimes && IsOf(t, r))).ToList();
            foreach (PlannedRun run in Runs) Take(run);
        }

        /// <summary>The shards by their number.</summary>
        public IReadOnlyList<ShardResults> Shards { get; }

        /// <summary>The verb.</summary>
        public ShardedVerb Verb => Shards[0].Verb;

        /// <summary>The runs of the plan in their order; without times, those that measure more than times.</summary>
        public IReadOnlyList<PlannedRun> Runs { get; }

        /// <summary>Runs that more than one shard has, with equal results.</summary>
        public int Repeated { get; private set; }

        /// <summary>Runs that no shard has finished.</summary>
        public IReadOnlyList<PlannedRun> Missing => Runs.Where(r => !owners.ContainsKey(r.Key)).ToList();

        /// <summary>Whether a run is there.</summary>
        public bool Has(string run) => owners.ContainsKey(run);

        /// <summary>The lines of a whole table, in the order of the plan.</summary>
        public IEnumerable<string> Lines(ShardedTable table) =>
            from run in Runs
            where IsOf(table, run) && Has(run.Key)
            from line in owners[run.Key].LinesOf(run.Key)
            select errorsOnly ? table.WithoutTimes(line) : line;

        /// <summary>
        /// Which shards lack runs, for instance "3 of shard 2/4, which is not among the folders"; empty where shards of several sizes are
        /// merged.
        /// </summary>
        public string DescribeMissing()
        {
            if (Shards.Any(s => s.Manifest.Shard.Count != Shards[0].Manifest.Shard.Count)) return "";
            return string.Join("; ", Missing.GroupBy(r => r.Shard).OrderBy(g => g.Key).Select(group =>
            {
                var shard = new Shard(group.Key, Shards[0].Manifest.Shard.Count);
                ShardResults given = Shards.FirstOrDefault(s => s.Manifest.Shard.Equals(shard));
                return $"{group.Count()} of shard {shard}, " +
                    $"{(given == null ? "which is not among the folders" : $"which stopped early in '{given.Folder}'")}";
            }));
        }

        private void Refuse(ShardResults first, ShardResults other)
        {
            List<(string What, string Own, string Other)> differences = first.Manifest.Differences(other.Manifest, !errorsOnly).ToList();
            if (differences.Count == 0 && first.Plan.Hash != other.Plan.Hash)
            {
                differences
                    .Add(("plan", $"{first.Plan.Hash}, {first.Plan.Runs.Count} runs", $"{other.Plan.Hash}, {other.Plan.Runs.Count} runs"));
            }
            if (differences.Count == 0) return;
            string cure = differences.All(d => d.What == "device" || d.What == "processor")
                ? " Times of unlike devices do not compare; --errors-only merges all but the times." : "";
            throw new CommandLineException($"'{other.Folder}' is not of the same sweep as '{first.Folder}': " +
                string.Join("; ", differences.Select(d => $"its {d.What} is '{d.Other}', not '{d.Own}'")) + "." + cure);
        }

        private void Take(PlannedRun run)
        {
            List<ShardResults> having = Shards.Where(s => s.Has(run.Key)).ToList();
            if (having.Count == 0) return;
            owners.Add(run.Key, having[0]);
            Repeated += having.Count > 1 ? 1 : 0;
            foreach (ShardResults other in having.Skip(1)) RefuseUnequal(run, having[0], other);
        }

        private void RefuseUnequal(PlannedRun run, ShardResults one, ShardResults other)
        {
            ShardedTable table = Verb.Tables.First(t => IsOf(t, run));
            IReadOnlyList<string> a = one.LinesOf(run.Key), b = other.LinesOf(run.Key);
            string where = $"'{one.Folder}' and '{other.Folder}' both have the run {run.Key}, with unequal results";
            const string cure = "Leave one of the folders out, or measure its shard anew.";
            if (a.Count != b.Count) throw new CommandLineException($"{where}: {a.Count} lines and {b.Count}. {cure}");
            for (int i = 0; i < a.Count; i++)
            {
                string column = table.Difference(a[i], b[i]);
                if (column != null)
                {
                    throw new CommandLineException(
                        $"{where}: {column} is '{table.Cell(a[i], column)}' and '{table.Cell(b[i], column)}'. {cure}");
                }
            }
        }

        private static bool IsOf(ShardedTable table, PlannedRun run) => run.Key.StartsWith(table.File.Name + "|", StringComparison.Ordinal);
    }
}
