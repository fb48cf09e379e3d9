using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Threading;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The particles that a simulation starts with, brought to rest where its settings ask for it.</summary>
    internal static class RelaxedStart
    {
        // Speed that a particle may gain in a tenth of a second, over √(g dx): half of what is seen as a pop.
        private const double Gain = 0.05;
        private const double GainTime = 0.1;

        // Support radii over which a packing settles: what overlaps pushes its neighbours.
        private const double PackedReach = 2.0;

        // Without gravity, over c²/dx.
        private const double PackedAcceleration = 1e-3;

        /// <summary>Makes the particles and reports how.</summary>
        public static IReadOnlyList<FluidParticle> Particles(
            in FluidSpec spec, FluidStart start, CollisionScene collision, StartWatch watch, Action<FluidMessage> report)
        {
            if (spec.StartRelaxation == FluidStartRelaxation.None || start.Particles.Count == 0) return start.Particles;
            bool isSaved = spec.StartRelaxation == FluidStartRelaxation.Saved;
            if (!isSaved && !FluidMethods.Has(spec.Method, FluidMethodFeatures.RelaxedStart))
            {
                Report(spec, report, FluidSeverity.Warning,
                    $"Start Relaxation needs the method Standard; with {spec.Method} the liquid starts from its lattice.",
                    "Set Start Relaxation to None, or use the method Standard.");
                return start.Particles;
            }

            FluidSolverSettings settings = Settings(spec, start);
            var saved = new SavedStart(settings, start.Particles, collision.Solids);
            if (spec.SavedStart != null && saved.TryRead(spec.SavedStart.bytes, out FluidParticle[] rested)) return rested;
            if (isSaved || spec.SavedStart != null)
            {
                Report(spec, report, FluidSeverity.Info,
                    (spec.SavedStart == null ? "Saved Start is empty" : "The relaxed start was saved of another liquid or vessel") +
                    (isSaved ? ", so the liquid starts from its lattice." : ", so the liquid comes to rest anew."),
                    "Save it in the inspector: Save Relaxed Start.");
            }
            if (isSaved) return start.Particles;
            var clock = Stopwatch.StartNew();
            using (var bodies = new CollisionBodies(settings))
            {
                bodies.Update(collision.Solids);
                using (var relaxer =
                    new StartRelaxer(settings, spec.Profile.Shaders, start.Particles, bodies, Height(settings, start.Particles)))
                {
                    bool settled = Watched(watch, goesOn => relaxer.Run(Acceleration(settings), goesOn));
                    ReportResult(spec, report, relaxer, settled, clock.Elapsed.TotalSeconds);
                    saved.TryRead(saved.Write(relaxer.Read()), out FluidParticle[] particles); // as rounded as from the file
                    return particles;
                }
            }
        }

        // Play mode or the player may end while the liquid settles.
        private static bool Watched(StartWatch watch, Func<Func<FluidStartProgress, bool>, bool> run)
        {
            CancellationToken exit = Application.exitCancellationToken;
            try
            {
                return run(progress => !exit.IsCancellationRequested && watch.Continue(progress));
            }
            finally
            {
                watch.End();
            }
        }

        /// <summary>What relaxes a start: the method Standard, whatever method runs it.</summary>
        public static FluidSolverSettings Settings(FluidSpec spec, FluidStart start)
        {
            if (FluidMethods.Has(spec.Method, FluidMethodFeatures.RelaxedStart)) return Settings(start.Constants, spec.StartRelaxation);
            spec.Method = FluidMethodKind.Standard;
            return Settings(FluidConstants.Derive(spec, start, start.Gravity), spec.StartRelaxation);
        }

        /// <summary>The physics at rest: walls do not move, no face is open, and gravity acts only where it is asked for.</summary>
        public static FluidSolverSettings Settings(FluidSolverSettings settings, FluidStartRelaxation relaxation)
        {
            settings.Boundaries = new FluidBoundaries { Periodic = settings.Boundaries.Periodic };
            if (relaxation != FluidStartRelaxation.Packed) return settings;
            settings.Gravity = Vector3.zero;
            settings.BodyForce = default;
            return settings;
        }

        /// <summary>Largest acceleration that is left at rest [m/s²].</summary>
        public static double Acceleration(in FluidSolverSettings settings)
        {
            double gravity = settings.Gravity.magnitude;
            return gravity > 0.0
                ? Gain * Math.Sqrt(gravity * settings.Spacing) / GainTime
                : PackedAcceleration * settings.SoundSpeed * settings.SoundSpeed / settings.Spacing;
        }

        /// <summary>Height over which the liquid settles [m]: along gravity that of all its particles.</summary>
        public static double Height(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> particles)
        {
            if (!(settings.Gravity.sqrMagnitude > 0f)) return PackedReach * settings.SupportRadius;
            Vector3 down = settings.Gravity.normalized;
            float low = float.PositiveInfinity, high = float.NegativeInfinity;
            foreach (FluidParticle particle in particles)
            {
                float depth = Vector3.Dot(down, particle.Position);
                low = Mathf.Min(low, depth);
                high = Mathf.Max(high, depth);
            }
            return high - low + settings.Spacing;
        }

        private static void ReportResult(in FluidSpec spec, Action<FluidMessage> report, StartRelaxer relaxer, bool settled, double seconds)
        {
            string steps = FormattableString.Invariant($"{relaxer.Steps} damped steps ({seconds:0.0} s)");
            if (settled)
                Report(spec, report, FluidSeverity.Info,
                    FormattableString.Invariant($"The liquid came to rest in {steps}: no particle is accelerated by more than ") +
                    FormattableString.Invariant($"{relaxer.Acceleration:0.##} m/s²."), "");
            else
                Report(spec, report, FluidSeverity.Warning,
                    FormattableString.Invariant($"The liquid is not quite at rest after {steps}: a particle is still accelerated by ") +
                    FormattableString.Invariant($"{relaxer.Acceleration:0.##} m/s²."),
                    "What is left settles after the start. Liquid with a level surface, that fills its vessel, comes to rest sooner.");
        }

        private static void Report(in FluidSpec spec, Action<FluidMessage> report, FluidSeverity severity, string text, string cure) =>
            report(new FluidMessage(severity, FluidIssue.StartRelaxation, spec.Owner, text, cure));
    }
}
