using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The folder of a shard that is being measured: beside the tables it says what they are a part of, and which runs are finished.
    /// </summary>
    internal sealed class ShardFolder
    {
        private readonly string folder;
        private readonly ShardManifest begun; // null where nothing was
        private readonly ShardManifest manifest;
        private readonly ResultTable<ShardRunRow> finished;

        private ShardFolder(string folder, ShardManifest begun, ShardManifest manifest, ResultTable<ShardRunRow> finished)
        {
            this.folder = folder;
            this.begun = begun;
            this.manifest = manifest;
            this.finished = finished;
        }

        /// <summary>The files of every shard beside its tables.</summary>
        public static IEnumerable<ResultFile> Files => new[] { ShardManifest.Format.File, SweepPlan.Format.File, ShardRunRow.Format.File };

        /// <summary>The part.</summary>
        public Shard Shard => manifest.Shard;

        /// <summary>Runs of the whole plan, when the shard has taken its own.</summary>
        public int PlannedRuns => manifest.Runs;

        /// <summary>The folder of a session; null for one that does all of its runs.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="device">The graphics device.</param>
        /// <param name="resumes">Whether the session goes on from what is there.</param>
        /// <param name="files">The files that the session writes.</param>
        /// <exception cref="CommandLineException">The folder holds something else than this shard.</exception>
        public static ShardFolder Open(MeasuringArguments arguments, string device, bool resumes, IEnumerable<ResultFile> files)
        {
            string folder = arguments.OutputFolder, shown = CommandLineWords.Shown(folder);
            ShardManifest begun = Find(folder);
            if (arguments.Shard == null)
            {
                if (begun != null)
                {
                    throw new CommandLineException(
                        $"--out: '{shown}' holds shard {begun.Shard} of '{begun.Command}'. Go on with --shard {begun.Shard}, or name " +
                        "another folder.");
                }
                return null;
            }
            ShardManifest manifest = ShardManifest.Of(arguments, device);
            if (begun == null)
                RefuseTables(folder, files);
            else
                Refuse(begun, manifest, shown);
            ResultTable<ShardRunRow> finished = begun != null && resumes
                ? ResultTable<ShardRunRow>.Resume(ShardRunRow.Format, folder, device, () => new ShardRunRow())
                : new ResultTable<ShardRunRow>(ShardRunRow.Format, folder, device);
            return new ShardFolder(folder, begun, manifest, finished);
        }

        /// <summary>The shard's own jobs, in their order; manifest and plan are written.</summary>
        /// <param name="all">All jobs of the sweep.</param>
        /// <exception cref="IOException">The folder holds a shard of another plan, or cannot be written.</exception>
        public List<SessionJob> Take(IReadOnlyList<SessionJob> all)
        {
            SweepPlan plan = SweepPlan.Of(all, Shard.Count);
            if (begun != null && begun.Plan != plan.Hash)
            {
                throw new IOException(
                    $"--out: '{folder}' holds a shard of another plan ({begun.Plan} with {begun.Runs} runs; this one is {plan.Hash} with " +
                    $"{all.Count}). Name another folder.");
            }
            manifest.Plan = plan.Hash;
            manifest.Runs = all.Count;
            manifest.Date = begun?.Date ?? manifest.Date;
            ShardManifest.Format.Write(folder, new[] { manifest });
            plan.Write(folder);
            List<SessionJob> own = all.Where((job, i) => plan.Runs[i].Shard == Shard.Index).ToList();
            finished.Add(own.Where(j => !finished.Contains(j.Key) && j.IsDone()).Select(j => new ShardRunRow { Run = j.Key }).ToArray());
            return own;
        }

        /// <summary>Notes that a job is done and its rows are written.</summary>
        public void Finish(SessionJob job, TimeSpan time) => finished.Add(new ShardRunRow { Run = job.Key, Seconds = time.TotalSeconds });

        private static ShardManifest Find(string folder)
        {
            try
            {
                return ShardManifest.Find(folder);
            }
            catch (FormatException exception)
            {
                throw new CommandLineException($"--out: {exception.Message}. Name another folder, or move the file away.");
            }
        }

        // What was measured without --shard may be of another commit.
        private static void RefuseTables(string folder, IEnumerable<ResultFile> files)
        {
            string table = files.Select(f => f.Name)
                .FirstOrDefault(n => n.EndsWith(".csv", StringComparison.Ordinal) && File.Exists(Path.Combine(folder, n)));
            if (table != null)
            {
                throw new CommandLineException(
                    $"--out: '{CommandLineWords.Shown(folder)}' holds {table}, which no shard wrote. Name another folder.");
            }
        }

        private static void Refuse(ShardManifest begun, ShardManifest manifest, string shown)
        {
            if (!begun.Shard.Equals(manifest.Shard))
            {
                throw new CommandLineException(
                    $"--out: '{shown}' holds shard {begun.Shard} of '{begun.Command}', and this is shard {manifest.Shard}. " +
                    "Give each shard a folder of its own.");
            }
            foreach ((string what, string there, string here) in begun.Differences(manifest, true))
            {
                throw new CommandLineException(
                    $"--out: '{shown}' holds a shard of another {what}: '{there}', and this is '{here}'. Name another folder.");
            }
        }
    }
}
