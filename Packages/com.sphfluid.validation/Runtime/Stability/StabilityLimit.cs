using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A border that linear theory predicts and runs measure: a number, the runs about it, and what it should be. The runs are a cubic
    /// lattice that fills a periodic box without clamp of the pressure, 1e-4 dx beside its places and with speeds of 1e-4 c_eff; and
    /// particles that rest on the domain's floor.
    /// </summary>
    public sealed class StabilityLimit
    {
        /// <summary>Relative width of a measured border.</summary>
        public const double Tolerance = 0.01;

        private const double Sound = 10.0;
        private const double Disturbance = 1e-4;

        // Of the viscous runs: their steps are a hundred times as short, and the displacements in them must not drown in rounding.
        private const double ViscousDisturbance = 1e-2;

        private const int Seed = 1;

        // Beyond the border by ε a wave grows by 2√(2ε) a step, by 0.28 at 1 %: forty steps show it. What unequal kernels feed in at any
        // step grows by up to 0.2 a step, and changes the motion little from one to the next.
        private const int AcousticSteps = 40;
        private const double AcousticGrowth = 30.0;

        // Beyond its border by ε viscosity multiplies by 1 + 2ε a step; one of some hundred modes has to outgrow all that decay.
        private const int ViscousSteps = 500;
        private const double ViscousGrowth = 2.0;

        // A bounded motion just below the border is some ten times the disturbance.
        private const int WallSteps = 300;
        private const double WallGrowth = 300.0;

        private static readonly StabilityLimit[] thesis =
            Acoustic(1.35, 1.40, 2.0, 2.5, 3.0, 4.0).Concat(Viscous(0.115, 0.131, 1.7, 2.0, 3.0, 4.0))
                .Concat(Walls(0.0, 0.5, 1.0)).ToArray();

        private static readonly StabilityLimit[] thesisQuick =
            Acoustic(1.35, 1.40, 2.0, 3.0, 4.0).Concat(Viscous(0.115, 0.131, 2.0, 3.0)).Concat(Walls(0.0, 1.0)).ToArray();

        private static readonly StabilityLimit[] standard =
            Acoustic(0.86, 0.89, 2.0, 2.25, 2.5, 3.0, 4.0).Concat(Viscous(0.072, 0.077, 2.0, 2.25, 2.5, 3.0, 4.0)).ToArray();

        private static readonly StabilityLimit[] standardQuick =
            Acoustic(0.86, 0.89, 2.0, 2.25, 2.5, 3.0).Concat(Viscous(0.072, 0.077, 2.25, 3.0)).ToArray();

        private readonly Func<double, CaseMethod, CaseSetup> build;

        private StabilityLimit(string name, double kappa, double low, double high, double growth, Func<double, CaseMethod, CaseSetup> build)
        {
            Name = name;
            SupportRatio = kappa;
            TheoryLow = low;
            TheoryHigh = high;
            Growth = growth;
            this.build = build;
        }

        /// <summary>Name in tables, for instance "dt·c/R".</summary>
        public string Name { get; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; }

        /// <summary>Least value by theory.</summary>
        public double TheoryLow { get; }

        /// <summary>Greatest value by theory.</summary>
        public double TheoryHigh { get; }

        /// <summary>Growth of v_rms beyond which a run is unstable.</summary>
        public double Growth { get; }

        /// <summary>The borders of a method.</summary>
        /// <param name="method">The method.</param>
        /// <param name="quick">Whether for the short plan.</param>
        public static IReadOnlyList<StabilityLimit> Of(CaseMethod method, bool quick)
        {
            if (StabilityTheory.Of(method) == StabilityTheory.Robust) return Array.Empty<StabilityLimit>();
            if (StabilityTheory.Of(method) == StabilityTheory.Standard) return quick ? standardQuick : standard;
            return quick ? thesisQuick : thesis;
        }

        /// <summary>A search from well below theory to well above.</summary>
        public Bisection Search() => new Bisection(0.6 * TheoryLow, 1.5 * TheoryHigh, Tolerance);

        /// <summary>The run at a value.</summary>
        public CaseSetup Build(double value, CaseMethod method) => build(value, method);

        /// <summary>For progress lines.</summary>
        public override string ToString() => FormattableString.Invariant($"{Name}, κ {SupportRatio:G3}");

        // Ranges by von Neumann over all waves and κ = 2 to 4; derivation: Documentation~/stability.md.
        private static IEnumerable<StabilityLimit> Acoustic(double low, double high, params double[] kappas) => kappas.Select(kappa =>
            new StabilityLimit("dt·c/R", kappa, low, high, AcousticGrowth, (value, method) =>
            {
                double radius = kappa * StabilityConstants.Spacing;
                return Box(method, kappa, value * radius / Sound, 0.001 * Sound * radius, AcousticSteps, Disturbance);
            }));

        private static IEnumerable<StabilityLimit> Viscous(double low, double high, params double[] kappas) => kappas.Select(kappa =>
            new StabilityLimit("ν·dt/R²", kappa, low, high, ViscousGrowth, (value, method) =>
            {
                double radius = kappa * StabilityConstants.Spacing, step = 0.01 * radius / Sound;
                return Box(method, kappa, step, value * radius * radius / step, ViscousSteps, ViscousDisturbance);
            }));

        // x² + 4 ζ x = 4 with x = √k_w dt and c_w = 2 ζ √k_w.
        private static IEnumerable<StabilityLimit> Walls(params double[] ratios) => ratios.Select(ratio =>
        {
            double border = 2.0 * (Math.Sqrt(ratio * ratio + 1.0) - ratio);
            return new StabilityLimit(FormattableString.Invariant($"√k_w·dt, damping ratio {ratio}"), StabilityTheory.Thesis.SupportRatio,
                border, border, WallGrowth,
                (value, method) => Wall(method, value, ratio));
        });

        private static CaseSetup Box(CaseMethod method, double kappa, double timeStep, double viscosity, int steps, double mach)
        {
            var run = new StabilityRun { Method = method, Seed = Seed };
            CaseSetup setup = StabilityScenes.Box(run, kappa, Sound, timeStep, viscosity, 0.0).Setup;
            // An even number of particles a side: waves of two spacings, the first to go, fit.
            int side = (int)Math.Round(setup.Settings.DomainSize.x / StabilityConstants.Spacing);
            side += side & 1;
            Vector3 domain = Vector3.one * (float)(side * StabilityConstants.Spacing);
            setup.Settings.DomainSize = domain;
            List<Vector3> positions = CaseLattice.Box(new Vector3Int(side, side, side), StabilityConstants.Spacing, -0.5f * domain);
            CaseLattice.Jitter(positions, Disturbance * StabilityConstants.Spacing, Seed, 0.4999f * domain);
            return Finish(setup, positions, mach * Sound * StabilityTheory.Of(method).WaveSpeedRatio, timeStep, steps);
        }

        // Each alone on the floor, near the depth in the wall at which it carries them.
        private static CaseSetup Wall(CaseMethod method, double value, double dampingRatio)
        {
            const int side = 4;
            const double rate = 100.0, depth = 0.2;
            double apart = 2.5 * StabilityConstants.Spacing, width = side * apart;
            var domain = new Vector3((float)width, 1f, (float)width);
            double distance = 0.5 * StabilityConstants.Spacing, gravity = rate * rate * depth * distance, step = value / rate;
            FluidSolverSettings settings = new StabilityConstants
            {
                Method = method, DomainSize = domain, Support = StabilityTheory.Thesis.SupportRatio, Sound = 0.1, Viscosity = 0.0,
                TimeStep = step, Speed = 1.0, Gravity = new Vector3(0f, -(float)gravity, 0f),
            }.Settings();
            settings = settings.WithOwn((ref ThesisSettings own) =>
            {
                own.WallStiffness = (float)(rate * rate);
                own.WallDamping = (float)(2.0 * dampingRatio * rate);
                own.WallDistance = (float)distance;
            });
            var positions = new List<Vector3>();
            for (int i = 0; i < side * side; i++)
            {
                positions.Add(new Vector3((float)((i % side + 0.5) * apart - 0.5 * width), (float)((1.0 - depth) * distance - 0.5),
                    (float)((i / side + 0.5) * apart - 0.5 * width)));
            }
            var setup = new CaseSetup { Settings = settings };
            return Finish(setup, positions, Disturbance * rate * distance, step, WallSteps, Vector3.up);
        }

        private static CaseSetup Finish(CaseSetup setup, List<Vector3> positions, double speed, double timeStep, int steps,
            Vector3? only = null)
        {
            var random = new System.Random(Seed);
            float Part() => (float)(speed * (2.0 * random.NextDouble() - 1.0));
            setup.Particles =
                CaseLattice.Particles(positions, p => Vector3.Scale(new Vector3(Part(), Part(), Part()), only ?? Vector3.one));
            setup.Duration = steps * timeStep;
            setup.SampleInterval = timeStep; // the growth is measured from step to step
            return setup;
        }
    }

    /// <summary>A line of limits.csv: a measured border against theory.</summary>
    public sealed class LimitRow : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<LimitRow> Format = new TableFormat<LimitRow>("limits.csv")
            .Text("limit", r => r.Limit, (r, v) => r.Limit = v)
            .Text("method", r => r.Method, (r, v) => r.Method = v)
            .Number("kappa", r => r.SupportRatio, (r, v) => r.SupportRatio = v)
            .Number("measured_low", r => r.MeasuredLow, (r, v) => r.MeasuredLow = v)
            .Number("measured_high", r => r.MeasuredHigh, (r, v) => r.MeasuredHigh = v)
            .Number("theory_low", r => r.TheoryLow, (r, v) => r.TheoryLow = v)
            .Number("theory_high", r => r.TheoryHigh, (r, v) => r.TheoryHigh = v)
            .Flag("within_5_percent", r => r.IsWithin)
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v);

        // What theory is allowed to be off.
        private const double Allowed = 0.05;

        /// <summary>A row that is read from a file.</summary>
        public LimitRow()
        {
        }

        internal LimitRow(StabilityLimit limit, CaseMethod method, Bisection search)
        {
            Limit = limit.Name;
            Method = method.Name;
            SupportRatio = limit.SupportRatio;
            MeasuredLow = search.Low;
            MeasuredHigh = double.IsInfinity(search.High) ? double.NaN : search.High;
            TheoryLow = limit.TheoryLow;
            TheoryHigh = limit.TheoryHigh;
        }

        /// <summary>Name of the limit.</summary>
        public string Limit { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio { get; private set; }

        /// <summary>Greatest stable value; zero when none was.</summary>
        public double MeasuredLow { get; private set; }

        /// <summary>Least unstable value; not a number when none was.</summary>
        public double MeasuredHigh { get; private set; }

        /// <summary>Least border by theory.</summary>
        public double TheoryLow { get; private set; }

        /// <summary>Greatest border by theory.</summary>
        public double TheoryHigh { get; private set; }

        /// <summary>Whether the measured border is within 5 % of theory's range.</summary>
        public bool IsWithin => MeasuredLow >= TheoryLow * (1.0 - Allowed) && MeasuredHigh <= TheoryHigh * (1.0 + Allowed);

        /// <summary>Equal for the same limit and method.</summary>
        public override string Key => KeyOf(Limit, Method, SupportRatio);

        internal static string KeyOf(string limit, string method, double kappa) => string.Join("|", limit, method, CsvText.Text(kappa));
    }
}
