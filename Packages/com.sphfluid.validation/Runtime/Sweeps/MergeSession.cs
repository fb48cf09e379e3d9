using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Puts the tables of shards together and lets the verb write what follows from them.</summary>
    public sealed class MergeSession : IValidationSession
    {
        // Runs that a message names.
        private const int MostNamed = 3;

        private readonly MergeArguments arguments;
        private readonly SessionProgress progress;
        private readonly SweepMerge merge;
        private readonly string[] words;
        private readonly ResultFolder results;

        /// <summary>Reads and checks the shards; nothing is written yet.</summary>
        /// <param name="arguments">Which shards, and where the whole goes.</param>
        /// <param name="progress">Where it says what it found.</param>
        /// <exception cref="CommandLineException">The folders are not shards of one sweep, or the output's holds something else than merged
        /// results.</exception>
        public MergeSession(MergeArguments arguments, SessionProgress progress)
        {
            this.arguments = arguments;
            this.progress = progress;
            if (arguments.Folders.Count == 0)
            {
                throw new CommandLineException(
                    "name the folders of the shards, for instance: merge shards/1 shards/2 --out whole. In Unity they stand behind a " +
                    "lone --.");
            }
            merge = new SweepMerge(arguments.Folders.Select(ShardResults.Read).ToList(), arguments.ErrorsOnly);
            words = Manifest.Command.Split(' ').Skip(1).Prepend("--").Append("--out=" + Folder).ToArray();
            RequireOwnFolder();
            results = ResultFolder.Open(Folder, merge.Verb.Files(words).Append(ShardManifest.MergedFormat.File));
        }

        private string Folder => arguments.OutputFolder;

        private ShardManifest Manifest => merge.Shards[0].Manifest;

        /// <inheritdoc/>
        /// <exception cref="IncompleteException">All is written, but runs are missing.</exception>
        public bool Step()
        {
            Describe();
            foreach (ShardedTable table in merge.Verb.Tables)
            {
                List<string> lines = merge.Lines(table).ToList();
                if (lines.Count > 0) CsvText.WriteWhole(Path.Combine(Folder, table.File.Name), lines.Prepend(table.File.FirstLine));
            }
            ShardManifest.MergedFormat.Write(Folder, merge.Shards.Select(s => s.Manifest));
            merge.Verb.Copy(merge, Folder);
            results.Release(); // for the verb's own session
            Finish();
            progress
                .Say($"'{Folder}' holds what {(merge.Shards.Count == 1 ? "the one shard has" : $"the {merge.Shards.Count} shards have")}.");
            return merge.Missing.Count == 0 ? false : throw new IncompleteException(DescribeMissing());
        }

        /// <inheritdoc/>
        public void Dispose() => results.Close();

        private void Describe()
        {
            progress
                .Say(
                    $"'{Manifest.Command}' on {string.Join(" and ", merge.Shards.Select(s => s.Manifest.Device).Distinct())}, " +
                    $"{Manifest.Program}: " +
                $"{merge.Runs.Count - merge.Missing.Count} of {merge.Runs.Count} runs are in the shards.");
            if (merge.Repeated > 0)
            {
                progress
                    .Say(
                        $"{merge.Repeated} of them are in more than one shard, with equal results; those of the shard with the lowest " +
                        "number are taken.");
            }
            foreach (ShardResults shard in merge.Shards)
            {
                List<string> stopped = shard.Stopped.ToList();
                if (stopped.Count > 0)
                {
                    progress.Say($"'{shard.Folder}' was stopped within {Named(stopped)}; the lines of that are left out.");
                }
            }
        }

        private void Finish()
        {
            if (arguments.ErrorsOnly && merge.Verb.Draws)
            {
                progress.Say("The tables are without times, so there are no pictures and no report.");
            }
            if (arguments.ErrorsOnly || merge.Runs.Count == merge.Missing.Count) return;
            using (IValidationSession session = merge.Verb.Finish(words, Manifest.Device, progress))
            {
                while (session != null && session.Step())
                {
                }
            }
        }

        private string DescribeMissing()
        {
            string shards = merge.DescribeMissing();
            return $"merge: {merge.Missing.Count} of {merge.Runs.Count} runs are in no shard: " +
                $"{Named(merge.Missing.Select(r => r.Key).ToList())}" +
                $"{(shards.Length > 0 ? $" ({shards})" : "")}. Measure them by the shard's own command and merge again.";
        }

        private static string Named(IReadOnlyCollection<string> runs) =>
            string.Join(", ", runs.Take(MostNamed)) + (runs.Count > MostNamed ? $" and {runs.Count - MostNamed} more" : "");

        // Tables that were measured here, or more than these shards have, are not replaced.
        private void RequireOwnFolder()
        {
            string shown = CommandLineWords.Shown(Folder), full = MergeArguments.Full(Folder);
            if (arguments.Folders.Any(f => MergeArguments.Full(f) == full))
            {
                throw new CommandLineException($"--out: '{shown}' is one of the shards. Name another folder.");
            }
            bool merged = File.Exists(Path.Combine(Folder, ShardManifest.MergedFormat.FileName));
            foreach (ShardedTable table in merge.Verb.Tables)
            {
                string file = Path.Combine(Folder, table.File.Name);
                if (!File.Exists(file)) continue;
                if (!merged)
                {
                    throw new CommandLineException($"--out: '{shown}' holds {table.File.Name}, which no merge wrote. Name another folder.");
                }
                string lost = File.ReadLines(file).Skip(1).FirstOrDefault(line => !merge.Has(table.KeyOf(line) ?? ""));
                if (lost != null)
                {
                    throw new CommandLineException(
                        $"--out: {table.File.Name} in '{shown}' has what these shards do not have: " +
                        $"{table.KeyOf(lost) ?? "a broken line"}. Name another folder.");
                }
            }
        }
    }
}
