using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// The force of a jet on the wall that it hits, from what momentum the liquid loses, and the speed of the sheets in which it leaves. A
    /// jet that is turned through a right angle gives the wall ρ U² b a metre of its breadth, whatever happens within; by Bernoulli the
    /// sheets leave as fast as it came.
    /// </summary>
    public sealed class JetMetric : CaseMetric
    {
        internal const string ErrorName = "force";

        // Over b from the jet's middle: there the liquid at the wall, the slowest, has 98 % of U and more.
        private const double SheetsFrom = 2.0, SheetsTo = 3.0;

        private readonly double width, length, speed, from, to, sheetsSince, density;
        private readonly double[] pressures = new double[JetWall.Strips]; // sums over readings of the even flow [Pa]
        private readonly List<double> times = new List<double>();
        private readonly List<double> momenta = new List<double>(); // of all particles' velocities toward the wall [m/s]
        private double sheetSpeeds, energies;
        private int sheets, readings;

        /// <summary>A metric for one run.</summary>
        /// <param name="width">b [m].</param>
        /// <param name="length">Length of the jet at the start, which flies along −x [m].</param>
        /// <param name="speed">U [m/s].</param>
        /// <param name="from">Where the flow is even from, in b/U.</param>
        /// <param name="to">Where that ends, in b/U.</param>
        /// <param name="density">Mass of the liquid in a volume [kg/m³].</param>
        public JetMetric(double width, double length, double speed, double from, double to, double density)
        {
            this.width = width;
            this.length = length;
            this.speed = speed;
            this.from = from;
            this.to = to;
            this.density = density;
            sheetsSince = 0.5 * (from + to); // their fronts are beyond
        }

        /// <inheritdoc/>
        public override void Read(double time, CaseReadings readings)
        {
            double t = time * speed / width;
            if (readings.Pressures.Count == 0 || t < from || t > to) return;
            for (int i = 0; i < pressures.Length; i++) pressures[i] += readings.Pressures[i];
            this.readings++;
        }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            double momentum = 0.0, t = time * speed / width;
            for (int i = 0; i < state.Count; i++)
            {
                Vector3 velocity = state.Velocities[i];
                momentum -= velocity.x;
                double off = Math.Abs(state.LocalPositions[i].y) / width;
                if (t < sheetsSince || t > to || off < SheetsFrom || off > SheetsTo) continue;
                sheetSpeeds += Math.Sign(state.LocalPositions[i].y) * velocity.y;
                energies += velocity.sqrMagnitude;
                sheets++;
            }
            times.Add(t);
            momenta.Add(momentum);
        }

        // Of a length of b: what ρ U² b gives the wall in b/U.
        private double Unit => momenta[0] * width / length;

        /// <summary>
        /// The force's error over ρ U² b, absolute; the same with its sign; how uneven the force is while the flow is even; speed of the
        /// sheets over U less 1; what they have lost of their kinetic energy. Where the wall's pressure is measured also the RMS of its
        /// error along the wall over ½ρU², and how far what the strips bear is from the force by momentum.
        /// </summary>
        public override IReadOnlyList<CaseError> Evaluate()
        {
            var line = new LineFit();
            for (int i = 0; i < times.Count; i++)
            {
                if (times[i] >= from && times[i] <= to) line.Add(times[i], momenta[i]);
            }
            double squares = 0.0;
            int count = 0;
            foreach ((double time, double force) in Forces())
            {
                if (time < from || time > to) continue;
                squares += (force + line.Slope / Unit) * (force + line.Slope / Unit);
                count++;
            }
            double error = -line.Slope / Unit - 1.0;
            var errors = new List<CaseError>
            {
                new CaseError(ErrorName, Math.Abs(error)),
                new CaseError("force over ρ U² b − 1", error),
                new CaseError("force, RMS about its mean", Math.Sqrt(squares / count)),
                new CaseError("speed of the sheets over U − 1", sheetSpeeds / sheets / speed - 1.0),
                new CaseError("energy lost by the sheets", 1.0 - energies / sheets / (speed * speed)),
            };
            if (readings > 0) AddWall(errors, error + 1.0);
            return errors;
        }

        /// <inheritdoc/>
        public override IReadOnlyList<CaseSeries> Series()
        {
            var exact = new CaseSeries("momentum of the jet", true);
            var measured = new CaseSeries("force");
            foreach ((double time, double force) in Forces())
            {
                measured.Add(time, force);
                if (time >= from && time <= to) exact.Add(time, 1.0);
            }
            return new[] { exact, measured };
        }

        // The strips reach 2 b to each side, where 99 % of the force are.
        private void AddWall(List<CaseError> errors, double force)
        {
            double squares = 0.0, borne = 0.0, exact = 0.0, unit = 0.5 * density * speed * speed;
            for (int i = 0; i < pressures.Length; i++)
            {
                double measured = pressures[i] / readings / unit, right = JetWall.Pressure(i);
                squares += (measured - right) * (measured - right);
                borne += measured;
                exact += right;
            }
            errors.Add(new CaseError("pressure along the wall, RMS over ½ρU²", Math.Sqrt(squares / pressures.Length)));
            errors.Add(new CaseError("force of the wall's strips over that by momentum − 1", borne / exact / force - 1.0));
        }

        // Between each two samples, over ρ U² b.
        private IEnumerable<(double Time, double Force)> Forces()
        {
            for (int i = 1; i < times.Count; i++)
            {
                yield return (0.5 * (times[i - 1] + times[i]), (momenta[i - 1] - momenta[i]) / Unit / (times[i] - times[i - 1]));
            }
        }
    }
}
