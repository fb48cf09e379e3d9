using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What of a liquid is exported at its start: particles, constants and colliders.</summary>
    internal sealed class ExportStart
    {
        private ExportStart(in ExportConstants constants, LiquidParticle[] particles, CollisionScene collision)
        {
            Constants = constants;
            Particles = particles;
            Collision = collision;
        }

        public ExportConstants Constants { get; }

        /// <summary>The particles in the order of their numbers.</summary>
        public LiquidParticle[] Particles { get; }

        /// <summary>The colliders, gathered.</summary>
        public CollisionScene Collision { get; }

        /// <summary>A liquid as it is now.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="solver">Its solver.</param>
        public static ExportStart OfRunning(in FluidSpec spec, FluidSolver solver)
        {
            var particles = new List<FluidParticle>();
            FluidReports.TryReadParticles(solver, particles);
            particles.Sort((a, b) => a.Id.CompareTo(b.Id));
            var collision = new CollisionScene();
            collision.Gather(spec.Query());
            return new ExportStart(ExportConstants.Of(spec, solver.Settings), Rows(particles), collision);
        }

        /// <summary>
        /// A liquid as it is filled and brought to rest. Limits of this device and Max Particles of the profile do not hold.
        /// </summary>
        /// <param name="asked">The simulation.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="watch">Watches how it comes to rest.</param>
        /// <param name="report">Receives what is wrong or worth knowing.</param>
        /// <returns>Null when an error was reported.</returns>
        public static ExportStart TryMake(in FluidSpec asked, IReadOnlyList<VolumeSpec> volumes, in StartWatch watch,
            Action<FluidMessage> report)
        {
            FluidSpec spec = AsComputed(asked);
            var collision = new CollisionScene();
            bool made = false;
            try
            {
                FluidStart start = Begin(spec, volumes, collision, report);
                if (start == null) return null;
                IReadOnlyList<FluidParticle> particles = Rested(spec, start, collision, watch, report);
                if (particles == null) return null;
                made = true;
                return new ExportStart(ExportConstants.Of(spec, start.Constants), Rows(particles), collision);
            }
            finally
            {
                if (!made) collision.Dispose();
            }
        }

        // Constants are those of Standard, whatever the method: the speed of sound is what the profile asks for.
        private static FluidSpec AsComputed(in FluidSpec asked)
        {
            FluidSpec spec = asked.AsSet();
            spec.Automatic = default;
            spec.Method = FluidMethodKind.Standard;
            spec.TimeStepMode = FluidTimeStepMode.Automatic;
            return spec;
        }

        // Null when an error was reported. What this device and its grid of cells hold limits no liquid that another machine computes.
        private static FluidStart Begin(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, CollisionScene collision,
            Action<FluidMessage> report)
        {
            FluidStart filled = null;
            List<FluidMessage> found = FluidChecks.Check(spec, collision,
                (now, messages) => filled = Fill(now, volumes, collision, messages), out FluidStart start);
            found.RemoveAll(m => m.Issue == FluidIssue.TooManyCells);
            foreach (FluidMessage message in found) report(message);
            if (start != null || filled == null || FluidChecks.HasErrors(found)) return start;
            try
            {
                filled.Constants = FluidConstants.Derive(spec, filled, filled.Gravity);
                return filled;
            }
            catch (ArgumentException exception)
            {
                report(FluidReports.Failure(spec.Owner, exception));
                return null;
            }
        }

        private static FluidStart Fill(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, CollisionScene collision,
            List<FluidMessage> messages)
        {
            if (spec.Playback != null) return PlayedLiquid.Begin(spec, messages);
            List<(VolumeSpec, LiquidShape shape)> found = LiquidChecks.Shapes(spec, volumes, collision, messages);
            if (found.Count == 0 && (volumes.Count > 0 || LiquidChecks.IsDry(spec))) return null;
            List<LiquidShape> shapes = found.ConvertAll(f => f.shape);
            SpawnRequest request = SpawnRequests.For(spec, shapes, collision);
            request.MaxParticles = int.MaxValue;
            SpawnResult result = FluidSpawner.Fill(request);
            LiquidChecks.Check(spec, found, result, collision, messages);
            return new FluidStart(result.Particles, result.Needed, LiquidExtent.Create(shapes, spec.DomainSize),
                result.Fastest)
            { Gravity = spec.LocalGravity };
        }

        private static IReadOnlyList<FluidParticle> Rested(in FluidSpec spec, FluidStart start, CollisionScene collision,
            in StartWatch watch, Action<FluidMessage> report)
        {
            bool fits = start.Particles.Count <= LiquidChecks.MostParticles(spec) &&
                CellChecks.Needed(start.Constants) <= CellChecks.Most(spec.Method);
            if (spec.StartRelaxation != FluidStartRelaxation.None && !fits)
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.StartRelaxation, spec.Owner,
                    "The liquid or its domain is larger than this device holds, so it is not brought to rest and exported as filled.",
                    "Let it settle in PySPH, or set Start Relaxation to None."));
                return start.Particles;
            }
            try
            {
                return RelaxedStart.Particles(spec, start, collision, watch, report);
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
            {
                report(FluidReports.Failure(spec.Owner, exception));
            }
            catch (OperationCanceledException)
            {
                report(new FluidMessage(FluidSeverity.Error, FluidIssue.StartRelaxation, spec.Owner,
                    "The export was ended before the liquid came to rest.", "Export again, or set Start Relaxation to None."));
            }
            return null;
        }

        private static LiquidParticle[] Rows(IReadOnlyList<FluidParticle> particles)
        {
            var rows = new LiquidParticle[particles.Count];
            for (int i = 0; i < rows.Length; i++) rows[i] = LiquidParticle.Of(particles[i]);
            return rows;
        }
    }
}
