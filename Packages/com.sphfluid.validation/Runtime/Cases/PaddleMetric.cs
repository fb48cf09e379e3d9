using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Levels at two gauges of a flume with a paddle, held against linear waves of the closed flume, start and reflection included; and the
    /// waves at the first of them, when they have become even and none has come back. Levels count from the mean over the flume.
    /// </summary>
    public sealed class PaddleMetric : CaseMetric
    {
        internal const string ErrorName = "levels at the gauges, RMS over their own";

        /// <summary>Places of the gauges over the depth: beyond the paddle's near field, and before the far wall.</summary>
        internal static readonly double[] Gauges = { 1.5, 3.5 };

        // Of the surface: the shortest is 4/5 of the depth long, 13 spacings at the base.
        private const int ModesPerLength = 5; // over 2 L/H

        // Twice the time that the waves' energy takes to the first gauge, and a period more than it takes there by way of the far wall.
        private readonly double even, reflected;
        private readonly TankModes tank;
        private readonly double wall, stroke, frequency;
        private readonly double[] measured;
        private readonly List<double> times = new List<double>();
        private readonly List<double>[] levels = { new List<double>(), new List<double>() };
        private readonly List<double>[] exact = { new List<double>(), new List<double>() };

        /// <summary>A metric for one run.</summary>
        /// <param name="tank">The flume.</param>
        /// <param name="wall">x of the paddle's face at the start [m], simulation space.</param>
        /// <param name="stroke">S [m].</param>
        /// <param name="waveNumber">k of waves of the paddle's frequency [1/m].</param>
        internal PaddleMetric(TankModes tank, double wall, double stroke, double waveNumber)
        {
            this.tank = tank;
            this.wall = wall;
            this.stroke = stroke;
            frequency = tank.FrequencyOf(waveNumber);
            measured = new double[(int)Math.Round(0.5 * ModesPerLength * tank.Length / tank.Depth)];
            double kh = waveNumber * tank.Depth;
            double groupSpeed = 0.5 * frequency / waveNumber * (1.0 + 2.0 * kh / Math.Sinh(2.0 * kh));
            even = 2.0 * Gauges[0] * tank.Depth / groupSpeed;
            reflected = (2.0 * tank.Length - Gauges[0] * tank.Depth) / groupSpeed;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double displaced = Displacement(time);
            tank.Measure(state, wall, measured, displaced);
            double[] linear = Enumerable.Range(1, measured.Length).Select(n => tank.Driven(n, stroke, frequency, time)).ToArray();
            times.Add(time);
            for (int gauge = 0; gauge < Gauges.Length; gauge++)
            {
                double x = Gauges[gauge] * tank.Depth;
                levels[gauge].Add(tank.Level(measured, x));
                exact[gauge].Add(tank.Level(linear, x));
            }
        }

        /// <summary>
        /// RMS over both gauges and time of the level's error over the exact level's; each gauge's; then of what swings with the paddle at
        /// the first gauge the height over the linear waves' in the same time, less 1, and how late it is, in periods.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            double[] errors = { Squares(0, true), Squares(1, true) }, own = { Squares(0, false), Squares(1, false) };
            (double height, double late) = EvenWaves();
            return new[]
            {
                new CaseError(ErrorName, Math.Sqrt((errors[0] + errors[1]) / (own[0] + own[1]))),
                new CaseError("level at the first gauge, RMS over its own", Math.Sqrt(errors[0] / own[0])),
                new CaseError("level at the second gauge, RMS over its own", Math.Sqrt(errors[1] / own[1])),
                new CaseError("height of the waves over the linear ones' − 1", height),
                new CaseError("waves late, in periods", late),
            };
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var series = new List<CaseSeries>();
            double period = 2.0 * Math.PI / frequency;
            for (int gauge = 0; gauge < Gauges.Length; gauge++)
            {
                string name = FormattableString.Invariant($"x = {Gauges[gauge]:0.0} H");
                var linear = new CaseSeries($"{name}, linear waves", true);
                var measured = new CaseSeries(name);
                for (int i = 0; i < times.Count; i++)
                {
                    linear.Add(times[i] / period, exact[gauge][i] / stroke);
                    measured.Add(times[i] / period, levels[gauge][i] / stroke);
                }
                series.Add(linear);
                series.Add(measured);
            }
            return series;
        }

        private double Displacement(double time) => 0.5 * stroke * (1.0 - Math.Cos(frequency * time));

        private double Squares(int gauge, bool error)
        {
            double sum = 0.0;
            for (int i = 0; i < times.Count; i++)
            {
                double value = error ? levels[gauge][i] - exact[gauge][i] : exact[gauge][i];
                sum += value * value;
            }
            return sum;
        }

        private (double Height, double Late) EvenWaves()
        {
            (double amplitude, double phase) = Swing(levels[0]);
            (double exactAmplitude, double exactPhase) = Swing(exact[0]);
            return (amplitude / exactAmplitude - 1.0, Math.IEEERemainder(phase - exactPhase, 2.0 * Math.PI) / (2.0 * Math.PI));
        }

        // Least squares of A cos ωt + B sin ωt + C between the two times; not a number where the run is shorter.
        private (double Amplitude, double Phase) Swing(List<double> values)
        {
            var m = new double[3, 4];
            for (int i = 0; i < times.Count; i++)
            {
                if (times[i] < even || times[i] > reflected) continue;
                double[] basis = { Math.Cos(frequency * times[i]), Math.Sin(frequency * times[i]), 1.0 };
                for (int row = 0; row < 3; row++)
                {
                    for (int column = 0; column < 3; column++) m[row, column] += basis[row] * basis[column];
                    m[row, 3] += basis[row] * values[i];
                }
            }
            double[] c = LinearSystem.Solve(m);
            return c == null || !(times[times.Count - 1] >= reflected) ? (double.NaN, double.NaN)
                : (Math.Sqrt(c[0] * c[0] + c[1] * c[1]), Math.Atan2(c[1], c[0]));
        }
    }
}
