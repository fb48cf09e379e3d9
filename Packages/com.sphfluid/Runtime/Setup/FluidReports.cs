using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Turns what can go wrong at a start or in a frame into messages.</summary>
    internal static class FluidReports
    {
        /// <summary>Checks the simulation and starts it.</summary>
        /// <returns>Null when an error was reported.</returns>
        public static FluidRun TryStart(FluidSimulation simulation, Action<FluidMessage> report)
        {
            if (!Application.isPlaying || !simulation.isActiveAndEnabled)
            {
                report(NotPlaying(simulation));
                return null;
            }
            var collision = new CollisionScene();
            List<FluidMessage> found = FluidValidation.Prepare(simulation, collision, true, out FluidStart start);
            foreach (FluidMessage message in found) report(message);
            if (start != null)
            {
                try
                {
                    return new FluidRun(simulation, start, collision);
                }
                catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
                {
                    report(Failure(simulation, exception));
                }
                catch (OperationCanceledException)
                {
                    report(new FluidMessage(FluidSeverity.Warning, FluidIssue.StartRelaxation, simulation,
                        "The start was ended before the liquid came to rest, so it does not run.",
                        "Start it again, or set Start Relaxation to None."));
                }
            }
            collision.Dispose();
            return null;
        }

        /// <summary>Advances by a frame.</summary>
        /// <returns>False when an error was reported and the run has to end.</returns>
        public static bool TryAdvance(FluidSimulation simulation, FluidRun run, float deltaTime)
        {
            try
            {
                run.Advance(deltaTime);
                return true;
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
            {
                ReportChange(simulation, exception);
                return false;
            }
        }

        // A check names the setting and the cure; the exception is told where no check knows of it.
        static void ReportChange(FluidSimulation simulation, Exception exception)
        {
            List<FluidMessage> found = FluidValidation.Validate(simulation);
            if (!FluidValidation.HasErrors(found)) found = new List<FluidMessage> { Failure(simulation, exception) };
            foreach (FluidMessage message in found)
                if (message.Severity == FluidSeverity.Error) simulation.Report(message);
        }

        /// <summary>The worst message as a line; empty when there is none.</summary>
        public static string Worst(IReadOnlyList<FluidMessage> messages)
        {
            FluidMessage? worst = null;
            foreach (FluidMessage message in messages)
                if (worst == null || message.Severity > worst.Value.Severity) worst = message;
            return worst?.ToString() ?? "";
        }

        /// <summary>Waits for the GPU and reads the particles of a solver, without those that left the domain.</summary>
        public static bool TryReadParticles(FluidSolver solver, List<FluidParticle> particles)
        {
            if (particles == null) throw new ArgumentNullException(nameof(particles));
            particles.Clear();
            if (solver == null) return false;
            var read = new FluidParticle[solver.ParticleCount];
            solver.Particles.GetData(read);
            particles.AddRange(Array.FindAll(read, p => !p.IsRemoved));
            return true;
        }

        // Nothing would free the GPU memory of a run that OnDisable does not end.
        static FluidMessage NotPlaying(FluidSimulation simulation) => SceneObjects.IsPrefabAsset(simulation)
            ? new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                "A prefab asset cannot run.", "Start an instance of it: what Instantiate returns, or one that is placed in a scene.")
            : Application.isPlaying
            ? new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                "The component or its object is disabled, so the simulation cannot start.", "Enable both first.")
            : new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                "Simulations run in play mode only.", "Press Play, or use FluidSolver directly in Editor tools.");

        static FluidMessage Failure(FluidSimulation simulation, Exception exception) => new FluidMessage(
            FluidSeverity.Error, exception is FluidDeviceException ? FluidIssue.DeviceUnsupported : FluidIssue.StartFailed,
            simulation, exception.Message, "");
    }
}
