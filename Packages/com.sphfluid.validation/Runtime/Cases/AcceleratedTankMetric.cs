using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Levels along a tank whose liquid a sideways acceleration sets swinging, held against linear waves. Modes 1 to 7 are measured; those
    /// of even number, which the exact linear waves do not have, are the second order's and count for nothing.
    /// </summary>
    public sealed class AcceleratedTankMetric : CaseMetric
    {
        internal const string ErrorName = "levels, RMS over their own";

        private const int Modes = 7;

        /// <summary>Periods of the first mode that levels are judged over; what moves besides is followed for one more.</summary>
        internal const double JudgedPeriods = 2.0;

        internal const string BesideName = "kinetic energy beside the waves', second period over the waves'";
        internal const string LeftName = "kinetic energy beside the waves', third period over second";

        private readonly TankModes tank;
        private readonly TankMotion motion;
        private readonly double wall, slope;
        private readonly List<double> times = new List<double>();
        private readonly List<double[]> modes = new List<double[]>();
        private readonly double[] besides = new double[(int)JudgedPeriods + 1];
        private double waves;

        /// <summary>A metric for one run.</summary>
        /// <param name="tank">The tank.</param>
        /// <param name="wall">x of the end wall of less x [m], simulation space.</param>
        /// <param name="floor">y of the floor [m].</param>
        /// <param name="slope">a/g: the level rises along x.</param>
        internal AcceleratedTankMetric(TankModes tank, double wall, double floor, double slope)
        {
            this.tank = tank;
            motion = new TankMotion(tank, wall, floor);
            this.wall = wall;
            this.slope = slope;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double periods = time * tank.Frequency(1) / (2.0 * Math.PI);
            SampleMotion((int)Math.Floor(periods), state);
            if (periods > JudgedPeriods + 1e-6) return;
            var measured = new double[Modes];
            tank.Measure(state, wall, measured);
            times.Add(time);
            modes.Add(measured);
        }

        /// <summary>
        /// RMS along the tank and over time of the level's error over the exact level's; the first mode's period; the slope that it swings
        /// about; the damping rate of its swing over its frequency; RMS of the second mode over the first, which second order makes;
        /// kinetic energy that is no linear wave's, in the second period over the waves' and in the third over the second: noise and what
        /// boils.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double error = 0.0, exact = 0.0, first = 0.0, second = 0.0;
            for (int i = 0; i < times.Count; i++)
            {
                for (int n = 1; n <= Modes; n += 2)
                {
                    double level = tank.Tilted(n, slope, times[i]), off = modes[i][n - 1] - level;
                    error += off * off;
                    exact += level * level;
                }
                first += modes[i][0] * modes[i][0];
                second += modes[i][1] * modes[i][1];
            }
            DampedOscillationFit swing = DampedOscillationFit.Of(times, modes.Select(m => m[0]).ToArray(), tank.Frequency(1),
                "accelerated-tank", "the first mode");
            double middle = swing?.Constant / tank.Tilted(1, slope, Math.PI / tank.Frequency(1)) * 2.0 ?? double.NaN;
            return new[]
            {
                new CaseError(ErrorName, Math.Sqrt(error / exact)),
                new CaseError("first mode's period, T/T_exact − 1", tank.Frequency(1) / swing?.Frequency - 1.0 ?? double.NaN),
                new CaseError("slope that it swings about over a/g − 1", middle - 1.0),
                new CaseError("first mode's damping rate over its frequency", swing?.DampingRate / swing?.Frequency ?? double.NaN),
                new CaseError("second mode over the first", Math.Sqrt(second / first)),
                new CaseError(BesideName, besides[1] / waves),
                new CaseError(LeftName, besides[2] / besides[1]),
            };
        }

        // Sums over the samples of a period, of which all have as many.
        private void SampleMotion(int period, FluidSnapshot state)
        {
            if (period >= besides.Length) return;
            (double ofWaves, double beside) = motion.Kinetic(state, Modes);
            besides[period] += beside;
            if (period == 1) waves += ofWaves;
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            double unit = 0.5 * slope * tank.Length;
            var series = new List<CaseSeries>();
            foreach ((string name, double x) in new[] { ("front wall", 0.0), ("back wall", tank.Length) })
            {
                var exact = new CaseSeries($"{name}, linear waves", true);
                var measured = new CaseSeries(name);
                for (int i = 0; i < times.Count; i++)
                {
                    double time = times[i];
                    exact.Add(time, tank.Level(Enumerable.Range(1, Modes).Select(n => tank.Tilted(n, slope, time)).ToArray(), x) / unit);
                    measured.Add(time, tank.Level(modes[i], x) / unit);
                }
                series.Add(exact);
                series.Add(measured);
            }
            return series;
        }
    }
}
