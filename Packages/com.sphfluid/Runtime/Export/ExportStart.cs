using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What of a liquid is exported at its start: particles, constants and colliders.</summary>
    internal sealed class ExportStart
    {
        ExportStart(in ExportConstants constants, LiquidParticle[] particles, CollisionScene collision)
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

        /// <summary>A liquid as it is filled and brought to rest. Limits of this device and Max Particles of the profile do not hold.</summary>
        /// <param name="asked">The simulation.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="watch">Watches how it comes to rest.</param>
        /// <param name="report">Receives what is wrong or worth knowing.</param>
        /// <returns>Null when an error was reported.</returns>
        public static ExportStart TryMake(in FluidSpec asked, IReadOnlyList<VolumeSpec> volumes, in StartWatch watch, Action<FluidMessage> report)
        {
            FluidSpec spec = Elsewhere(asked);
            var collision = new CollisionScene();
            bool made = false;
            try
            {
                List<FluidMessage> found = FluidChecks.Check(spec, volumes, collision, FluidSpawner.Fill, out FluidStart start);
                foreach (FluidMessage message in found) report(message);
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
        static FluidSpec Elsewhere(in FluidSpec asked)
        {
            FluidSpec spec = asked.AsSet();
            spec.Automatic = default;
            spec.Method = FluidMethodKind.Standard;
            spec.TimeStepMode = FluidTimeStepMode.Automatic;
            spec.RunsElsewhere = true;
            return spec;
        }

        static IReadOnlyList<FluidParticle> Rested(in FluidSpec spec, FluidStart start, CollisionScene collision, in StartWatch watch, Action<FluidMessage> report)
        {
            FluidSpec here = spec;
            here.RunsElsewhere = false;
            if (spec.StartRelaxation != FluidStartRelaxation.None && start.Particles.Count > LiquidChecks.MostParticles(here))
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.StartRelaxation, spec.Owner,
                    $"The liquid has {start.Particles.Count} particles, more than can come to rest on this device, so it is exported as filled.",
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

        static LiquidParticle[] Rows(IReadOnlyList<FluidParticle> particles)
        {
            var rows = new LiquidParticle[particles.Count];
            for (int i = 0; i < rows.Length; i++)
                rows[i] = LiquidParticle.Of(particles[i]);
            return rows;
        }
    }
}
