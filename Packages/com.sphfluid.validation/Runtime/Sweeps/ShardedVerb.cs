using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A measurement that can be divided among machines: its tables, and what follows from them when they are whole.</summary>
    internal sealed class ShardedVerb
    {
        private readonly Func<IReadOnlyList<string>, IEnumerable<ResultFile>> files;
        private readonly Action<SweepMerge, string> copy;
        private readonly Func<IReadOnlyList<string>, string, SessionProgress, IValidationSession> finish;

        /// <param name="name">The verb.</param>
        /// <param name="tables">The tables that shards write.</param>
        /// <param name="files">All files of a command, the tables among them.</param>
        /// <param name="copy">Brings further files of shards into the folder of the whole; null where there are none.</param>
        /// <param name="finish">The session that writes what follows from the tables of its folder, on a device; null where nothing
        /// does.</param>
        public ShardedVerb(string name, IReadOnlyList<ShardedTable> tables, Func<IReadOnlyList<string>, IEnumerable<ResultFile>> files,
            Action<SweepMerge, string> copy = null, Func<IReadOnlyList<string>, string, SessionProgress, IValidationSession> finish = null)
        {
            Name = name;
            Tables = tables;
            this.files = files;
            this.copy = copy;
            this.finish = finish;
        }

        /// <summary>All.</summary>
        public static IReadOnlyList<ShardedVerb> All { get; } = new[]
        {
            ChartShards.Verb,
            StabilityShards.Verb,
            new ShardedVerb("leaks", new[] { ShardedTable.Of(LeakResult.Format, new[] { "scene" }) },
                _ => new[] { LeakResult.Format.File }),
            new ShardedVerb("surfaces", new[] { ShardedTable.Of(SurfaceQuality.Format, new[] { "state", "variant" }, "gpu_ms") },
                _ => new[] { SurfaceQuality.Format.File }),
        };

        /// <summary>The verb.</summary>
        public string Name { get; }

        /// <summary>The tables.</summary>
        public IReadOnlyList<ShardedTable> Tables { get; }

        /// <summary>Whether pictures or a report follow from the tables.</summary>
        public bool Draws => finish != null;

        /// <summary>The verb of a name; null where there is none.</summary>
        public static ShardedVerb Find(string name) => All.FirstOrDefault(v => v.Name == name);

        /// <summary>All files of a command.</summary>
        /// <exception cref="CommandLineException">The command is none of this version.</exception>
        public IEnumerable<ResultFile> Files(IReadOnlyList<string> words) => files(words);

        /// <summary>Brings further files of shards into the folder of the whole.</summary>
        public void Copy(SweepMerge merge, string folder) => copy?.Invoke(merge, folder);

        /// <summary>The session that writes what follows from the tables; null where nothing does.</summary>
        public IValidationSession Finish(IReadOnlyList<string> words, string device, SessionProgress progress) =>
            finish?.Invoke(words, device, progress);
    }
}
