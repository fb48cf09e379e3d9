using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text;

namespace SphFluid.Validation
{
    /// <summary>The runs of a whole sweep in their order, and which shard does each: shard-plan.csv, the same in every shard.</summary>
    internal sealed class SweepPlan
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<PlannedRun> Format = new TableFormat<PlannedRun>("shard-plan.csv")
            .Text("run", r => r.Key, (r, v) => r.Key = v)
            .Text("cost", r => r.Cost, (r, v) => r.Cost = v)
            .Count("shard", r => r.Shard, (r, v) => r.Shard = checked((int)v));

        private SweepPlan(IReadOnlyList<PlannedRun> runs)
        {
            Runs = runs;
            Hash = HashOf(runs);
        }

        /// <summary>The runs in their order.</summary>
        public IReadOnlyList<PlannedRun> Runs { get; }

        /// <summary>
        /// Equal for the same runs with the same costs in the same order, however many shards there are: 16 hexadecimal digits.
        /// </summary>
        public string Hash { get; }

        /// <summary>Deals jobs to shards.</summary>
        /// <param name="jobs">All jobs in their order, whatever is done of them.</param>
        /// <param name="shards">Number of shards.</param>
        public static SweepPlan Of(IReadOnlyList<SessionJob> jobs, int shards)
        {
            // Four digits: the last bits of a cost may differ between the runtimes of two machines.
            string[] costs = jobs.Select(j => j.Cost.ToString("G4", CultureInfo.InvariantCulture)).ToArray();
            int[] deal = ShardDeal.Of(jobs.Select((job, i) => (job.Group, CsvText.Number(costs[i]))).ToList(), shards);
            return new SweepPlan(jobs.Select((job, i) => new PlannedRun { Key = job.Key, Cost = costs[i], Shard = deal[i] }).ToList());
        }

        /// <summary>Reads the file of a folder.</summary>
        /// <exception cref="FormatException">It is broken.</exception>
        public static SweepPlan Read(string folder)
        {
            string file = Path.Combine(folder, Format.FileName);
            var plan = new SweepPlan(Format.ReadAll(file, () => new PlannedRun()));
            string twice = plan.Runs.GroupBy(r => r.Key).Where(g => g.Count() > 1).Select(g => g.Key).FirstOrDefault();
            return twice == null ? plan : throw new FormatException($"'{file}' has the run {twice} twice");
        }

        /// <summary>Writes the file.</summary>
        public void Write(string folder) => Format.Write(folder, Runs);

        private static string HashOf(IEnumerable<PlannedRun> runs)
        {
            using (var sha = SHA256.Create())
            {
                byte[] hash =
                    sha.ComputeHash(Encoding.UTF8.GetBytes(string.Join("\n", runs.Select(r => CsvText.Join(new[] { r.Key, r.Cost })))));
                return string.Concat(hash.Take(8).Select(b => b.ToString("x2", CultureInfo.InvariantCulture)));
            }
        }
    }
}
