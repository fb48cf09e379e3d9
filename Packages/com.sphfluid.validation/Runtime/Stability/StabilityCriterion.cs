using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Watches a run and decides how it went. Failed: not finite, energy beyond 1.05 of the start's, a speed beyond 3 v_ref, 0.1 % beyond a
    /// wall by dx/2, mean compression grown by 10 %. Degraded at the end: moves by more than it may, 1 % of nearest distances below dx/2,
    /// height lost, accelerations or positions clamped, momentum drifted. There are no neighbour lists that could overflow.
    /// </summary>
    public sealed class StabilityCriterion : CaseMetric
    {
        /// <summary>Growth of the energy that fails a run, over the start's.</summary>
        public const double EnergyGrowth = 0.05;

        /// <summary>Speed that fails a run, over v_ref.</summary>
        public const double SpeedRatio = 3.0;

        /// <summary>Share of the particles beyond a wall that fails a run.</summary>
        public const double EscapedShare = 1e-3;

        /// <summary>Growth of the mean compression that fails a run.</summary>
        public const double Compression = 0.1;

        /// <summary>Share of the particles with a neighbour within dx/2 that degrades a run.</summary>
        public const double ClumpedShare = 0.01;

        /// <summary>Height loss beyond the equation of state's that degrades a run, over the depth.</summary>
        public const double HeightLoss = 0.02;

        /// <summary>Drift of the momentum of a closed system that degrades a run, over Σ m |v|.</summary>
        public const double MomentumDrift = 1e-3;

        private readonly StabilityScenario scene;
        private readonly FluidSolverSettings settings;
        private bool begun;
        private LiquidMotion first;
        private double firstEnergy;
        private double speedSquares, heights, clumped, drift, scale;
        private int settled;

        /// <summary>The criterion of one run.</summary>
        /// <param name="scene">What is run, and what is expected of it.</param>
        public StabilityCriterion(StabilityScenario scene)
        {
            this.scene = scene;
            settings = scene.Setup.Settings;
        }

        /// <summary>Why it failed; none while it did not.</summary>
        public StabilityCause Cause { get; private set; }

        /// <inheritdoc/>
        public override void Sample(double time, FluidSnapshot state)
        {
            LiquidMotion now = LiquidMotion.Of(state, settings);
            LiquidEnergy energy = LiquidEnergy.Of(state, settings);
            double total = energy.Total + Lowest * settings.ParticleMass * state.Count;
            if (!begun) (first, firstEnergy) = (now, total);
            begun = true;
            FailBy(now, total, state);
            if (Failure != null) return;
            scale = Math.Max(scale, now.MomentumScale);
            drift = Math.Max(drift, math.length(now.Momentum - first.Momentum));
            if (time >= scene.SettledFrom) Settle(energy.Kinetic, state);
        }

        /// <summary>v_rms/rest speed, share of close particles, height loss and momentum drift, as far as they are scene.</summary>
        public override IReadOnlyList<CaseError> Evaluate() => new[]
        {
            new CaseError("v_rms [m/s]", RmsSpeed),
            new CaseError("share of particles with a neighbour within dx/2", clumped),
            new CaseError("height lost beyond the equation of state's", Sinking),
            new CaseError("momentum drift", Drift),
        };

        /// <summary>How it went.</summary>
        /// <param name="result">What the run gave.</param>
        /// <param name="cut">Whether the run was cut short, and how; empty when it was not.</param>
        public StabilityOutcome Conclude(CaseResult result, string cut = "")
        {
            var outcome = new StabilityOutcome { Particles = result.Particles, Steps = result.Steps };
            if (result.Failed)
            {
                outcome.Verdict = StabilityVerdict.Failed;
                // What every run is ended by: numbers that are none, and, where there is a wall, liquid beyond it.
                outcome.Cause = Cause != StabilityCause.None ? Cause
                    : result.Counters.NonFinite == 0 && !double.IsNaN(scene.WallTop) ? StabilityCause.Escape : StabilityCause.NotFinite;
                outcome.Reason = result.Failure;
                outcome.TimeToFailure = result.SimulatedSeconds;
                return outcome;
            }
            outcome.Reason = Degradation(result, out outcome.Cause);
            outcome.Verdict = outcome.Cause == StabilityCause.None ? StabilityVerdict.Stable : StabilityVerdict.Degraded;
            outcome.Reason += (outcome.Reason.Length > 0 && cut.Length > 0 ? "; " : "") + cut;
            return outcome;
        }

        private double RmsSpeed => settled == 0 ? double.NaN : Math.Sqrt(speedSquares / settled);

        private double Drift => drift / Math.Max(scale, 1e-300);

        private double Sinking
        {
            get
            {
                if (scene.Depth <= 0.0 || settled == 0) return double.NaN;
                double sound = LiquidEnergy.EffectiveSound(settings);
                double m = sound * sound / (settings.Gravity.magnitude * scene.Depth);
                return HydrostaticMetric.HeightRatio(m) - heights / settled / scene.Depth;
            }
        }

        // Gravity's potential at the lowest corner of the domain is −this [J/kg]: with it energies start at zero there.
        private double Lowest
        {
            get
            {
                Vector3 g = settings.Gravity, size = settings.DomainSize;
                return 0.5 * (Math.Abs((double)g.x) * size.x + Math.Abs((double)g.y) * size.y + Math.Abs((double)g.z) * size.z);
            }
        }

        private void FailBy(in LiquidMotion now, double energy, FluidSnapshot state)
        {
            double start = Math.Max(firstEnergy, scene.EnergyScale), growth = energy - firstEnergy;
            double escaped = EscapedNow(state);
            if (!(energy < double.PositiveInfinity) || !(now.MaxSpeed < double.PositiveInfinity))
                Fail(StabilityCause.NotFinite, "a position or velocity is not finite");
            else if (now.MaxSpeed > SpeedRatio * scene.ReferenceSpeed)
                Fail(StabilityCause.Speed, FormattableString.Invariant($"a particle has {now.MaxSpeed / scene.ReferenceSpeed:G3} v_ref"));
            else if (growth > EnergyGrowth * start)
                Fail(StabilityCause.Energy,
                    FormattableString.Invariant($"the energy grew by {growth / start:P1} of ") +
                    FormattableString.Invariant($"{(start > firstEnergy ? "½ M v_ref²" : "the start's")}"));
            else if (escaped > EscapedShare)
                Fail(StabilityCause.Escape, FormattableString.Invariant($"{escaped:P2} of the particles are beyond a wall by dx/2"));
            else if (now.MeanCompression - first.MeanCompression > Compression)
                Fail(StabilityCause.Compression,
                    FormattableString.Invariant($"the mean compression grew by {now.MeanCompression - first.MeanCompression:P1}"));
        }

        private void Fail(StabilityCause cause, string text)
        {
            Cause = cause;
            Failure = text;
        }

        private double EscapedNow(FluidSnapshot state)
        {
            float depth = 0.5f * settings.Spacing;
            Vector3 half = 0.5f * settings.DomainSize + depth * Vector3.one;
            int escaped = 0;
            foreach (Vector3 p in state.LocalPositions)
            {
                bool out3 = Mathf.Abs(p.x) > half.x || Mathf.Abs(p.y) > half.y || Mathf.Abs(p.z) > half.z;
                escaped += out3 || p.y < scene.WallTop - depth ? 1 : 0;
            }
            return escaped / (double)Math.Max(1, state.Count);
        }

        private void Settle(double kinetic, FluidSnapshot state)
        {
            settled++;
            speedSquares += 2.0 * kinetic / (settings.ParticleMass * (double)state.Count);
            clumped = Math.Max(clumped, LiquidMotion.ClosePairs(state, settings, 0.5 * settings.Spacing));
            if (scene.Depth > 0.0) heights += LiquidMotion.ColumnHeight(state, settings, scene.Depth);
        }

        private string Degradation(CaseResult result, out StabilityCause cause)
        {
            // A box at rest has no momentum to speak of: its drift is compared with all of it at a thousandth of v_ref.
            double floor = 1e-3 * scene.ReferenceSpeed * settings.ParticleMass * result.Particles;
            FluidCounters counters = result.Counters;
            long hits = counters.AccelerationLimitHits + counters.DomainClamps;
            cause = StabilityCause.None;
            if (scene.RestSpeed > 0.0 && RmsSpeed > scene.RestSpeed)
            {
                return Degrade(out cause, StabilityCause.Restless,
                    FormattableString.Invariant($"v_rms is {RmsSpeed / scene.ReferenceSpeed:G3} v_ref at the end"));
            }
            if (clumped > ClumpedShare)
            {
                return Degrade(out cause, StabilityCause.Clumped,
                    FormattableString.Invariant($"{clumped:P1} of the particles have a neighbour within dx/2"));
            }
            if (Sinking > HeightLoss)
            {
                return Degrade(out cause, StabilityCause.Sunk,
                    FormattableString.Invariant($"{Sinking:P1} of the depth is lost beyond the equation of state's"));
            }
            if (hits > 0)
            {
                return Degrade(out cause, StabilityCause.Clamped,
                    FormattableString.Invariant($"{counters.AccelerationLimitHits} accelerations and {counters.DomainClamps} positions ") +
                    "were clamped");
            }
            if (scene.Closed && drift > MomentumDrift * Math.Max(scale, floor))
            {
                return Degrade(out cause, StabilityCause.Drift,
                    FormattableString.Invariant($"the momentum drifted by {Drift:G2} of Σ m|v|"));
            }
            return "";
        }

        private static string Degrade(out StabilityCause cause, StabilityCause found, string text)
        {
            cause = found;
            return text;
        }
    }
}
