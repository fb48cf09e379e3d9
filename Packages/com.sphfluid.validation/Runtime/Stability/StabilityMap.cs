using System;
using System.Collections.Generic;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>An axis of a map.</summary>
    public sealed class StabilityAxis
    {
        /// <summary>An axis.</summary>
        /// <param name="title">What it is, for instance "dt·c/R".</param>
        /// <param name="low">Its first value.</param>
        /// <param name="high">Its last value.</param>
        /// <param name="isLogarithmic">Whether its values have equal ratios instead of equal differences.</param>
        public StabilityAxis(string title, double low, double high, bool isLogarithmic = true)
        {
            Title = title;
            Low = low;
            High = high;
            IsLogarithmic = isLogarithmic;
        }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>First value.</summary>
        public double Low { get; }

        /// <summary>Last value.</summary>
        public double High { get; }

        /// <summary>Whether its values have equal ratios.</summary>
        public bool IsLogarithmic { get; }

        /// <summary>Values from the first to the last, rounded to the six digits that files have.</summary>
        /// <param name="count">Number of values, two or more.</param>
        public IReadOnlyList<double> Values(int count)
        {
            if (count < 2) throw new ArgumentOutOfRangeException(nameof(count), count, "An axis needs two values or more.");
            var values = new double[count];
            for (int i = 0; i < count; i++)
            {
                double value = At(i / (count - 1.0));
                values[i] = double.Parse(CsvText.Text(Math.Abs(value) < 1e-9 ? 0.0 : value), CultureInfo.InvariantCulture);
            }
            return values;
        }

        /// <summary>Value at a place, 0 for the first and 1 for the last.</summary>
        public double At(double place) => IsLogarithmic ? Low * Math.Pow(High / Low, place) : Low + (High - Low) * place;

        /// <summary>Place on the axis, 0 at the first value and 1 at the last.</summary>
        public double Place(double value) => IsLogarithmic ? Math.Log(value / Low) / Math.Log(High / Low) : (value - Low) / (High - Low);
    }

    /// <summary>A line that theory draws into a map, for the methods that it holds for.</summary>
    public sealed class TheoryLine
    {
        /// <summary>A line x(y).</summary>
        /// <param name="theory">The methods.</param>
        /// <param name="title">What it is.</param>
        /// <param name="x">Abscissa at an ordinate.</param>
        public TheoryLine(StabilityTheory theory, string title, Func<double, double> x)
        {
            Theory = theory;
            Title = title;
            X = x;
        }

        /// <summary>A level line.</summary>
        /// <param name="theory">The methods.</param>
        /// <param name="title">What it is.</param>
        /// <param name="y">Its ordinate.</param>
        public TheoryLine(StabilityTheory theory, string title, double y)
        {
            Theory = theory;
            Title = title;
            Level = y;
        }

        /// <summary>The methods that it holds for.</summary>
        public StabilityTheory Theory { get; }

        /// <summary>What it is.</summary>
        public string Title { get; }

        /// <summary>Abscissa at an ordinate; null for a level line.</summary>
        public Func<double, double> X { get; }

        /// <summary>Ordinate of a level line.</summary>
        public double Level { get; }
    }

    /// <summary>A map: two axes, a scene for each cell and the lines that theory draws.</summary>
    public sealed class StabilityMap
    {
        private const string WallTitle = "wall, k_w dt² = 4 − 2 c_w dt";

        private static readonly StabilityTheory thesis = StabilityTheory.Thesis, standard = StabilityTheory.Standard;

        // k_w dt² = 4 − 2 c_w dt with critical damping, c_w = 2 √k_w: √k_w dt = √8 − 2.
        private static readonly double wallBorder = Math.Sqrt(8.0) - 2.0;

        private readonly Func<StabilityRun, StabilityScenario> build;

        private StabilityMap(string name, string title, StabilityAxis x, StabilityAxis y, Func<StabilityRun, StabilityScenario> build,
            params TheoryLine[] lines)
        {
            Name = name;
            Title = title;
            X = x;
            Y = y;
            this.build = build;
            Lines = lines;
        }

        /// <summary>M1 to M6.</summary>
        public static IReadOnlyList<StabilityMap> All { get; } = new[]
        {
            new StabilityMap("M1", "Column at rest", new StabilityAxis("dt·c/R", 0.05, 2.0), new StabilityAxis("c/√(gH)", 2.0, 40.0),
                StabilityScenes.Column,
                Sound(thesis, y => thesis.AcousticBorder), Sound(standard, y => standard.AcousticBorder),
                // The wall stops √(2gH) within dx/2: √k_w = 2 √(2gH)/dx.
                new TheoryLine(thesis, WallTitle, y => wallBorder * y / (Math.Sqrt(8.0) * thesis.SupportRatio))),
            new StabilityMap("M2", "Periodic box, viscosity", new StabilityAxis("ν·dt/R²", 0.005, 0.3),
                new StabilityAxis("dt·c/R", 0.05, 2.0), StabilityScenes.ViscousBox,
                Viscosity(thesis), Viscosity(standard), SoundLevel(thesis), SoundLevel(standard)),
            new StabilityMap("M3", "Two blocks collide", new StabilityAxis("dt·v/dx", 0.05, 2.0), new StabilityAxis("c/v", 2.0, 40.0),
                StabilityScenes.Collision,
                Sound(thesis, y => thesis.AcousticBorder * thesis.SupportRatio / y),
                Sound(standard, y => standard.AcousticBorder * standard.SupportRatio / y)),
            new StabilityMap("M4", "Periodic box under pressure", new StabilityAxis("P/(ρc²)", -0.1, 0.3, false),
                new StabilityAxis("κ = R/dx", 1.7, 4.0, false),
                StabilityScenes.PressedBox),
            new StabilityMap("M5", "Spray hits a slab", new StabilityAxis("v·dt/dx", 0.05, 2.0),
                new StabilityAxis("thickness/dx", 0.1, 4.0), StabilityScenes.Spray,
                // The wall stops v within dx/2: √k_w = 2 v/dx.
                new TheoryLine(thesis, WallTitle, y => 0.5 * wallBorder), Advised(thesis), Advised(standard)),
            new StabilityMap("M6", "Two drops collide", new StabilityAxis("dt·v/dx", 0.05, 2.0), new StabilityAxis("c/v", 2.0, 40.0),
                StabilityScenes.Drops,
                Sound(thesis, y => thesis.AcousticBorder * thesis.SupportRatio / y),
                Sound(standard, y => standard.AcousticBorder * standard.SupportRatio / y)),
        };

        /// <summary>Name on the command line: M1 to M6.</summary>
        public string Name { get; }

        /// <summary>What it shows.</summary>
        public string Title { get; }

        /// <summary>Horizontal axis.</summary>
        public StabilityAxis X { get; }

        /// <summary>Vertical axis.</summary>
        public StabilityAxis Y { get; }

        /// <summary>Borders by theory.</summary>
        public IReadOnlyList<TheoryLine> Lines { get; }

        /// <summary>The scene of a cell.</summary>
        /// <param name="run">Cell, method, seed, clamps and most steps.</param>
        public StabilityScenario Build(StabilityRun run) => build(run).Cut(run.MostSteps);

        private static TheoryLine Sound(StabilityTheory theory, Func<double, double> x) => new TheoryLine(theory, SoundTitle(theory), x);

        private static TheoryLine SoundLevel(StabilityTheory theory) => new TheoryLine(theory, SoundTitle(theory), theory.AcousticBorder);

        private static string SoundTitle(StabilityTheory theory) =>
            FormattableString.Invariant($"sound, dt·c/R = {theory.AcousticBorder:G3}");

        private static TheoryLine Viscosity(StabilityTheory theory) =>
            new TheoryLine(theory, FormattableString.Invariant($"viscosity, ν·dt/R² = {theory.ViscousBorder:G3}"),
                y => theory.ViscousBorder);

        private static TheoryLine Advised(StabilityTheory theory) =>
            new TheoryLine(theory, FormattableString.Invariant($"advised, v·dt/dx = {TimeStepAdvice.SpeedLimit}"),
                y => TimeStepAdvice.SpeedLimit);
    }
}
