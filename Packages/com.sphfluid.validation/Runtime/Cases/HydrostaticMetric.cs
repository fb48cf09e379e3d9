using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Averages a column at rest over the end of its run: pressure over depth, pressure on the floor, height, what still moves,
    /// density. Layers of three spacings at the surface, at the floor and at side walls are left out of the slope and of density.
    /// </summary>
    public sealed class HydrostaticMetric : CaseMetric
    {
        /// <summary>Spacings left out at the surface, at the floor and at side walls.</summary>
        public const double LeftOut = FloorPressure.Edge;

        internal const string ErrorName = "slope of the pressure that pushes";
        internal const string FaceName = "pressure on the floor/(ρgH)";
        internal const string EdgesName = "pressure on the floor's edges/(ρgH)";

        private readonly FluidSolverSettings settings;
        private readonly double depth, gravity, begin;
        private readonly int layer;
        private readonly FloorPressure floorPressure;
        private readonly LineFit line = new LineFit();
        private readonly double[] binSums;
        private readonly int[] binCounts;
        private double heights, speedSquares, densityErrors;
        private int samples;
        private long particles;

        /// <summary>A metric for one run.</summary>
        /// <param name="settings">The run's constants; gravity along −y, the floor is the domain's lower face.</param>
        /// <param name="depth">Height H of the column at rest density [m].</param>
        /// <param name="layer">Particles in a horizontal layer.</param>
        /// <param name="begin">Time from which it is averaged [s].</param>
        public HydrostaticMetric(in FluidSolverSettings settings, double depth, int layer, double begin)
        {
            this.settings = settings;
            this.depth = depth;
            this.layer = layer;
            this.begin = begin;
            gravity = -settings.Gravity.y;
            floorPressure = new FloorPressure(settings);
            int bins = Math.Max(1, (int)Math.Round(depth / settings.Spacing));
            binSums = new double[bins];
            binCounts = new int[bins];
        }

        /// <summary>Height ratio h/H of a liquid of p = c² (ρ − ρ0) at rest, c² = m g H: m ln(1 + 1/m).</summary>
        /// <param name="m">c²/(g H).</param>
        public static double HeightRatio(double m) => m * Math.Log(1.0 + 1.0 / m);

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double dx = settings.Spacing;
            double floor = -0.5 * settings.DomainSize.y;
            double height = Height(state, floor);
            if (!(height > (2.0 * LeftOut + 2.0) * dx))
            {
                Failure = FormattableString.Invariant($"the column has sunk to {height / dx:0.#} dx of height; nothing is left to measure");
            }
            if (time < begin || Failure != null) return;
            samples++;
            heights += height;
            floorPressure.Sample(state);
            for (int i = 0; i < state.Count; i++)
            {
                speedSquares += state.Velocities[i].sqrMagnitude;
                Vector3 position = state.LocalPositions[i];
                double above = position.y - floor;
                double below = height - above;
                int bin = (int)Math.Floor(below / dx);
                if (bin >= 0 && bin < binSums.Length)
                {
                    binSums[bin] += state.Pressures[i];
                    binCounts[bin]++;
                }
                if (above < LeftOut * dx || below < LeftOut * dx || FloorPressure.IsNearSide(settings, position)) continue;
                line.Add(Exact(below), state.Pressures[i]);
                densityErrors += Math.Abs(state.Densities[i] / (double)settings.RestDensity - 1.0);
            }
            particles += state.Count;
        }

        /// <summary>
        /// |slope/(ρ g) − 1| of the pressure that pushes, ρ as the equation of state has it at that depth, so that methods compare like for
        /// like; the slope itself, as read and as it pushes (half of it with the ½ of the thesis's equation (13)); pressure on the floor
        /// over the liquid's weight, as it pushes, on the face and, with side walls, at the edges; height lost beyond the equation of
        /// state's; v_rms/√(gH); mean |ρ/ρ0 − 1|.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double slope = line.Slope, weight = settings.RestDensity * gravity * depth;
            var errors = new List<CaseError>
            {
                new CaseError(ErrorName, Math.Abs(Share * slope - 1.0)),
                new CaseError("slope/(ρg), as read", slope),
                new CaseError("slope/(ρg), as it pushes", Share * slope),
                new CaseError(FaceName, Share * floorPressure.Face / weight),
            };
            if (floorPressure.HasEdges) errors.Add(new CaseError(EdgesName, Share * floorPressure.Edges / weight));
            errors.Add(new CaseError("height lost beyond the equation of state's", HeightRatio(M) - heights / samples / depth));
            errors.Add(new CaseError("v_rms/√(gH)", Math.Sqrt(speedSquares / particles / (gravity * depth))));
            errors.Add(new CaseError("mean |ρ/ρ0 − 1|", densityErrors / line.Count));
            return errors;
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            double unit = settings.RestDensity * gravity * depth;
            double bin = depth / binSums.Length;
            var exact = new CaseSeries("equation of state", true);
            for (int b = 0; b <= binSums.Length; b++) exact.Add(b * bin / depth, Exact(b * bin) / unit);
            var read = new CaseSeries("pressure as read");
            var pushes = new CaseSeries("pressure as it pushes");
            for (int b = 0; b < binSums.Length; b++)
            {
                if (binCounts[b] == 0) continue;
                double pressure = binSums[b] / binCounts[b] / unit;
                read.Add((b + 0.5) * bin / depth, pressure);
                pushes.Add((b + 0.5) * bin / depth, Share * pressure);
            }
            return HalvesPressure ? new[] { exact, read, pushes } : new[] { exact, read };
        }

        // c²/(g H).
        private double M => Sound * Sound / (gravity * depth);

        private double Sound => CaseSettings.EffectiveSoundSpeed(settings);

        // Of the pressure as it is read, what pushes.
        private double Share => HalvesPressure ? 0.5 : 1.0;

        // Equation (13) of the thesis has ½ (p_i + p_j).
        private bool HalvesPressure => CaseMethod.IsThesis(settings) && settings.Own<ThesisSettings>().PressureHalf;

        // ρ0 c² (e^x − 1), x = g d/c²: ρ g d of liquid that its own weight compresses. The hyperbolic sine keeps the digits of a small x.
        private double Exact(double below)
        {
            double square = Sound * Sound;
            double half = 0.5 * gravity * below / square;
            return settings.RestDensity * square * 2.0 * Math.Sinh(half) * Math.Exp(half);
        }

        private double Height(FluidSnapshot state, double floor)
        {
            var above = new double[state.Count];
            for (int i = 0; i < above.Length; i++) above[i] = state.LocalPositions[i].y - floor;
            return LiquidSurface.Height(above, layer, settings.Spacing);
        }
    }
}
