using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What a shard is a part of: shard.csv, a line in its folder.</summary>
    internal sealed class ShardManifest
    {
        /// <summary>The file of a shard.</summary>
        public static readonly TableFormat<ShardManifest> Format = Columns("shard.csv");

        /// <summary>The file of merged results: a line for each shard.</summary>
        public static readonly TableFormat<ShardManifest> MergedFormat = Columns("shards.csv");

        private int index, count;

        /// <summary>What is measured, see <see cref="MeasuringArguments.Command"/>; the verb is its first word.</summary>
        public string Command { get; private set; }

        /// <summary>The verb.</summary>
        public string Verb { get; private set; }

        /// <summary>The part.</summary>
        public Shard Shard => new Shard(index, count);

        /// <summary>See <see cref="SweepPlan.Hash"/>.</summary>
        public string Plan { get; set; } = "";

        /// <summary>Runs of the whole plan.</summary>
        public int Runs { get; set; }

        /// <summary>The graphics device.</summary>
        public string Device { get; private set; }

        /// <summary>Day on which the shard was begun.</summary>
        public string Date { get; set; }

        private string Commit { get; set; }

        private string Version { get; set; }

        private string Assemblies { get; set; }

        private string Processor { get; set; }

        private bool IsSoftware { get; set; }

        /// <summary>The program: its commit, or where it has none its version with a hash of its assemblies.</summary>
        public string Program => Commit.Length > 0 ? "commit " + Commit : $"version {Version}, assemblies {Assemblies}";

        /// <summary>The manifest of this process; the plan is not known yet.</summary>
        /// <param name="arguments">What to measure, with its shard.</param>
        /// <param name="device">The graphics device.</param>
        public static ShardManifest Of(MeasuringArguments arguments, string device) => new ShardManifest
        {
            Verb = arguments.Verb,
            Command = arguments.Command,
            index = arguments.Shard.Index,
            count = arguments.Shard.Count,
            Commit = SweepBuild.Commit,
            Version = SweepBuild.Version,
            Assemblies = SweepBuild.Assemblies,
            Device = device,
            IsSoftware = FluidSupport.IsSoftwareDevice,
            Processor = string.Format(CultureInfo.InvariantCulture, "{0}, {1} threads", SystemInfo.processorType,
                SystemInfo.processorCount),
            Date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture),
        };

        /// <summary>The manifest of a folder; null where it has none.</summary>
        /// <exception cref="FormatException">It is broken.</exception>
        public static ShardManifest Find(string folder)
        {
            string file = Path.Combine(folder, Format.FileName);
            if (!File.Exists(file) || !StartsAsOurs(file)) return null;
            List<ShardManifest> rows = Format.ReadAll(file, () => new ShardManifest());
            if (rows.Count != 1 || !rows[0].Shard.IsPossible || !rows[0].Command.StartsWith(rows[0].Verb, StringComparison.Ordinal))
            {
                throw new FormatException($"'{file}' does not have one line that names a shard");
            }
            return rows[0];
        }

        /// <summary>
        /// In what two shards differ that must be alike: command, program and, as times are compared, the device. A software device's times
        /// are the processor's, so that must be alike too.
        /// </summary>
        /// <param name="other">The other one.</param>
        /// <param name="sameDevice">Whether times are compared.</param>
        public IEnumerable<(string What, string Own, string Other)> Differences(ShardManifest other, bool sameDevice)
        {
            if (Command != other.Command) yield return ("command", Command, other.Command);
            if (Program != other.Program) yield return ("program", Program, other.Program);
            if (sameDevice && Device != other.Device)
                yield return ("device", Device, other.Device);
            else if (sameDevice && IsSoftware && Processor != other.Processor)
                yield return ("processor", Processor, other.Processor);
        }

        private static bool StartsAsOurs(string file)
        {
            using (var reader = new StreamReader(file))
                return reader.ReadLine() == Format.FirstLine;
        }

        private static TableFormat<ShardManifest> Columns(string fileName) => new TableFormat<ShardManifest>(fileName)
            .Text("verb", m => m.Verb, (m, v) => m.Verb = v)
            .Text("command", m => m.Command, (m, v) => m.Command = v)
            .Count("shard", m => m.index, (m, v) => m.index = checked((int)v))
            .Count("shards", m => m.count, (m, v) => m.count = checked((int)v))
            .Text("plan", m => m.Plan, (m, v) => m.Plan = v)
            .Count("runs", m => m.Runs, (m, v) => m.Runs = checked((int)v))
            .Text("commit", m => m.Commit, (m, v) => m.Commit = v)
            .Text("version", m => m.Version, (m, v) => m.Version = v)
            .Text("assemblies", m => m.Assemblies, (m, v) => m.Assemblies = v)
            .Text("device", m => m.Device, (m, v) => m.Device = v)
            .Flag("software", m => m.IsSoftware, (m, v) => m.IsSoftware = v)
            .Text("processor", m => m.Processor, (m, v) => m.Processor = v)
            .Text("date", m => m.Date, (m, v) => m.Date = v);
    }
}
