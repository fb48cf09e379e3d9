using System;
using System.Collections.Generic;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>What <c>bench</c> measures and where it writes.</summary>
    public sealed class BenchArguments : MeasuringArguments
    {
        /// <summary>Fewest samples of a row: a median of fewer says little.</summary>
        public const int MinimumSamples = 5;

        /// <summary>The thesis's tables 3 and 4.</summary>
        public const string ThesisTable = "thesis";

        /// <summary>The thesis's pipeline against the Standard method.</summary>
        public const string SolverTable = "solver";

        /// <summary>Surfaces alone: the thesis's against sparse ones.</summary>
        public const string SurfaceTable = "surface";

        /// <summary>A sequence of particle files, streamed.</summary>
        public const string PlaybackTable = "playback";

        /// <summary>Every table but that of playback, which has no GPU times.</summary>
        public const string AllTables = "all";

        private const int MaximumSamples = 1000;
        private const int MinimumParticles = 64;

        private static readonly string[] tables = { ThesisTable, SolverTable, SurfaceTable, AllTables, PlaybackTable };

        internal BenchArguments() : base("bench", "Build/bench")
        {
            Options.Add("--table", "NAME", "what is measured; all is the first three", ThesisTable, tables,
                flag => Table = flag.OneOf(tables));
            Options.Add("--particles", "LIST", "numbers of particles, with commas", "those of the table",
                flag => Particles = List(flag.Name, flag.Value(), MinimumParticles, FluidProfile.ParticleLimit));
            Options.Add("--grids", "LIST", "cells a side of marching cubes, with commas, or none", "those of the table",
                flag => Grids = Cells(flag.Name, flag.Value()));
            Options.Add("--repeat", "R", $"samples of each row, {MinimumSamples} or more", $"{MinimumSamples}",
                flag => Samples = Number(flag.Name, flag.Value(), MinimumSamples, MaximumSamples));
            AddFolder();
            Options.Add("--sweep", "with --table thesis: also 4,096 to 1,048,576 particles, as on a real GPU by itself",
                flag => SetSweep(flag.On()));
            Options.Add("--no-sweep", "without them", flag => SetSweep(!flag.On()));
        }

        /// <summary>
        /// The table: <see cref="ThesisTable"/>, <see cref="SolverTable"/>, <see cref="SurfaceTable"/> <see cref="AllTables"/> or
        /// <see cref="PlaybackTable"/>.
        /// </summary>
        public string Table { get; private set; } = ThesisTable;

        /// <summary>Numbers of particles; null leaves them to the table and the device.</summary>
        public IReadOnlyList<int> Particles { get; private set; }

        /// <summary>Cells a side of the marching-cubes grids; null leaves them to the table.</summary>
        public IReadOnlyList<int> Grids { get; private set; }

        /// <summary>Samples of each row, <see cref="MinimumSamples"/> or more.</summary>
        public int Samples { get; private set; } = MinimumSamples;

        /// <summary>
        /// Whether the sweep over the number of particles is measured too; null leaves it to the device: yes on a graphics card.
        /// </summary>
        public bool? Sweep { get; private set; }

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, or a value is missing or wrong.</exception>
        public static BenchArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new BenchArguments();
            result.Read(commandLine);
            return result;
        }

        /// <summary>Whether a table is asked for.</summary>
        /// <param name="table">Its name.</param>
        internal bool Includes(string table) => Table == table || Table == AllTables && table != PlaybackTable;

        private void SetSweep(bool sweep) =>
            Sweep = Sweep.HasValue ? throw new CommandLineException("--sweep and --no-sweep exclude each other; give one.") : sweep;

        private static int[] Cells(string flag, string value) => value == "none" ? Array.Empty<int>()
            : List(flag, value, 1, SurfaceGrid.MaximumCells);

        private static int[] List(string flag, string value, int minimum, int maximum)
        {
            string[] words = value.Split(',');
            var numbers = new List<int>();
            foreach (string word in words)
            {
                int number = Number(flag, word.Trim(), minimum, maximum);
                if (numbers.Contains(number)) throw new CommandLineException($"{flag} has {number} twice.");
                numbers.Add(number);
            }
            return numbers.ToArray();
        }

        private static int Number(string flag, string value, int minimum, int maximum)
        {
            if (int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= minimum &&
                number <= maximum)
            {
                return number;
            }
            string what = flag == "--repeat" ? "a whole number" : "whole numbers divided by commas, each";
            throw new CommandLineException($"{flag} must be {what} from {minimum} to {maximum}, found '{CommandLineWords.Shown(value)}'.");
        }
    }
}
