using System;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>A run of a map: a cell, a method, a seed, with or without clamps.</summary>
    public sealed class StabilityRun
    {
        // Work that a step has whatever the number of particles, in particles.
        const double StepOverhead = 1500.0;

        StabilityScenario built;

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

        /// <summary>Expected work: steps × (particles, and what a step costs anyway).</summary>
        public double Cost
        {
            get
            {
                built = built ?? Build();
                double ratio = built.Setup.Settings.SupportRadius / built.Setup.Settings.Spacing / 2.0;
                return built.Setup.Duration / built.Setup.Settings.TimeStep * (built.Setup.Particles.Length * (0.4 + 0.6 * ratio * ratio * ratio) + StepOverhead);
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
