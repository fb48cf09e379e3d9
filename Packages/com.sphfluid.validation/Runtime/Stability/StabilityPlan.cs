using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Which cells are run, in their order, and which borders are bisected: maps without clamps, borders, maps with clamps. The short plan
    /// leaves the last out.
    /// </summary>
    public sealed class StabilityPlan
    {
        private const int FullSeeds = 3;

        // Columns and rows.
        private static readonly IReadOnlyDictionary<string, (int X, int Y)> quickCells = new Dictionary<string, (int X, int Y)>
        {
            ["M1"] = (9, 5), ["M2"] = (9, 8), ["M3"] = (9, 7), ["M4"] = (9, 5), ["M5"] = (9, 7), ["M6"] = (9, 7),
        };

        private static readonly IReadOnlyDictionary<string, (int X, int Y)> fullCells = new Dictionary<string, (int X, int Y)>
        {
            ["M1"] = (17, 9), ["M2"] = (17, 15), ["M3"] = (17, 13), ["M4"] = (17, 8), ["M5"] = (17, 13), ["M6"] = (17, 13),
        };

        private readonly List<StabilityRun> runs = new List<StabilityRun>();
        private readonly List<StabilityRun> clamped = new List<StabilityRun>();
        private readonly List<(StabilityLimit Limit, CaseMethod Method)> limits = new List<(StabilityLimit, CaseMethod)>();

        /// <summary>Runs of the principal maps.</summary>
        public IReadOnlyList<StabilityRun> Runs => runs;

        /// <summary>Runs of the maps with clamps.</summary>
        public IReadOnlyList<StabilityRun> Clamped => clamped;

        /// <summary>Borders to bisect.</summary>
        public IReadOnlyList<(StabilityLimit Limit, CaseMethod Method)> Limits => limits;

        /// <summary>The cells of a command.</summary>
        /// <param name="arguments">Maps, methods, and whether it is the short plan.</param>
        /// <param name="software">Whether the device is a CPU: runs are then cut shorter.</param>
        public static StabilityPlan Of(StabilityArguments arguments, bool software)
        {
            var plan = new StabilityPlan();
            double mostSteps = arguments.Quick ? QuickSteps : software ? SoftwareSteps : FullSteps;
            int seeds = arguments.Quick ? 1 : FullSeeds;
            foreach (bool clamps in arguments.Quick ? new[] { false } : new[] { false, true })
            {
                for (int seed = 1; seed <= seeds; seed++)
                {
                    foreach (StabilityMap map in arguments.Maps)
                    {
                        (int x, int y) = (arguments.Quick ? quickCells : fullCells)[map.Name];
                        foreach (CaseMethod method in arguments.Methods.Where(m => !clamps || StabilityTheory.Of(m).HasAccelerationLimit))
                        {
                            (clamps ? plan.clamped : plan.runs).AddRange(Cells(map, method, x, y, seed, clamps, mostSteps));
                        }
                    }
                }
            }
            if (arguments.Limits)
            {
                plan.limits.AddRange(from method in arguments.Methods from limit in StabilityLimit.Of(method, arguments.Quick)
                                     select (limit, method));
            }
            return plan;
        }

        /// <summary>Most steps of a run of the short plan.</summary>
        public const double QuickSteps = 500.0;

        // On a device that is a CPU, and on others.
        private const double SoftwareSteps = 4000.0, FullSteps = 100000.0;

        private static IEnumerable<StabilityRun> Cells(StabilityMap map, CaseMethod method, int columns, int rows, int seed, bool clamps,
            double mostSteps) =>
                from y in map.Y.Values(rows)
                from x in map.X.Values(columns)
                select new StabilityRun { Map = map, Method = method, X = x, Y = y, Seed = seed, Clamps = clamps, MostSteps = mostSteps };
    }

    /// <summary>A run of a map: a cell, a method, a seed, with or without clamps.</summary>
    public sealed class StabilityRun
    {
        // Work that a step has whatever the number of particles, in particles.
        private const double StepOverhead = 1500.0;

        private StabilityScenario built;

        /// <summary>The map.</summary>
        public StabilityMap Map { get; set; }

        /// <summary>The method.</summary>
        public CaseMethod Method { get; set; }

        /// <summary>Value of the horizontal axis.</summary>
        public double X { get; set; }

        /// <summary>Value of the vertical axis.</summary>
        public double Y { get; set; }

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed { get; set; }

        /// <summary>Whether the emergency limit on accelerations acts.</summary>
        public bool Clamps { get; set; }

        /// <summary>Most steps that it may do.</summary>
        public double MostSteps { get; set; } = double.PositiveInfinity;

        /// <summary>Equal for equal runs, whatever their length.</summary>
        public string Key => KeyOf(Map.Name, Method.Name, X, Y, Seed, Clamps);

        /// <summary>Expected work of a step at κ = 2.</summary>
        internal static double CostOfStep(int particles) => particles + StepOverhead;

        /// <summary>Expected work: steps × (particles, and what a step costs anyway).</summary>
        public double Cost
        {
            get
            {
                built = built ?? Build();
                double ratio = built.Setup.Settings.SupportRadius / built.Setup.Settings.Spacing / 2.0;
                return built.Setup.Duration / built.Setup.Settings.TimeStep *
                    (built.Setup.Particles.Length * (0.4 + 0.6 * ratio * ratio * ratio) + StepOverhead);
            }
        }

        /// <summary>A fresh scene of the cell.</summary>
        public StabilityScenario Build() => Map.Build(this);

        /// <summary>For progress lines, for instance "M1, thesis, 1.35, 10".</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0}, {1}, {2} {3:G3}, {4} {5:G3}, seed {6}{7}",
            Map.Name, Method.Name, Map.X.Title, X, Map.Y.Title, Y, Seed, Clamps ? ", with clamps" : "");

        internal static string KeyOf(string map, string method, double x, double y, int seed, bool clamps) =>
            string.Join("|", map, method, CsvText.Text(x), CsvText.Text(y), CsvText.Text(seed), clamps ? "on" : "off");
    }
}
