using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>How a liquid is computed in a run of <c>budgets</c>: by a given method, or as Automatic picks it for a budget.</summary>
    internal sealed class BudgetWay
    {
        // The compression of which the accuracy cases are a tenth or less, 1 %, and three times as much, as Automatic takes it.
        private const float Compression = 0.01f, Ratio = 10f;
        private const float SoftCompression = 3f * Compression, SoftRatio = 5.7735f;

        private BudgetWay(string name, FluidMethodKind method, float compression = Compression, float ratio = Ratio)
        {
            Name = name;
            Method = method;
            MaxCompression = compression;
            SoundSpeedRatio = ratio;
        }

        /// <summary>Name in tables.</summary>
        public string Name { get; }

        /// <summary>The method.</summary>
        public FluidMethodKind Method { get; }

        /// <summary>Of the profile.</summary>
        public float MaxCompression { get; }

        /// <summary>Of the profile.</summary>
        public float SoundSpeedRatio { get; }

        /// <summary>Equal steps of a frame; 0: as the profile has them.</summary>
        public int Substeps { get; private set; }

        /// <summary>Milliseconds that a frame's steps may take; not a number where the method is given.</summary>
        public double Budget { get; private set; } = double.NaN;

        /// <summary>What errors are measured against: a liquid compressed by a quarter of a percent.</summary>
        public static BudgetWay Reference { get; } = new BudgetWay("reference", FluidMethodKind.Standard, 0.0025f, 20f);

        /// <summary>
        /// The ways that Automatic has, each given, and what it does not take: few substeps, and liquid that only its iterations make soft.
        /// </summary>
        public static IReadOnlyList<BudgetWay> Given { get; } = new[]
        {
            new BudgetWay("standard", FluidMethodKind.Standard),
            new BudgetWay("standard-soft", FluidMethodKind.Standard, SoftCompression, SoftRatio),
            Robust(1), Robust(2), Robust(4), Robust(6), Robust(8), Robust(12), Robust(16), PositionBased(2),
        };

        private static BudgetWay Robust(int substeps) =>
            new BudgetWay($"robust-{substeps}", FluidMethodKind.Robust) { Substeps = substeps };

        // With a speed of sound that its iterations never reach the compliance has no say: position based fluids (Macklin & Mueller 2013).
        private static BudgetWay PositionBased(int substeps) =>
            new BudgetWay($"position-based-{substeps}", FluidMethodKind.Robust, 0.001f, 20f) { Substeps = substeps };

        /// <summary>Automatic with a budget.</summary>
        /// <param name="milliseconds">The budget [ms].</param>
        public static BudgetWay Chosen(double milliseconds) =>
            new BudgetWay($"automatic-{CsvText.Text(milliseconds)}", FluidMethodKind.Automatic) { Budget = milliseconds };
    }
}
