using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Turns what can go wrong at a start or in a frame into messages.</summary>
    internal static class FluidReports
    {
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

        /// <summary>Whether a simulation can start now; reports why not.</summary>
        public static bool MayStart(Behaviour simulation, Action<FluidMessage> report)
        {
            if (!(NotPlaying(simulation) is FluidMessage obstacle)) return true;
            report(obstacle);
            return false;
        }

        /// <summary>Whether a saved liquid can take the place of a simulation's; reports why not.</summary>
        public static bool MayRestore(in FluidSpec spec, Action<FluidMessage> report)
        {
            if (spec.Playback == null) return true;
            report(new FluidMessage(FluidSeverity.Error, FluidIssue.SaveInvalid, spec.Owner,
                "The liquid is played back, so the save was not restored.", "Disable the component that plays it first."));
            return false;
        }

        // Null when it can. Nothing would free the GPU memory of a run that OnDisable does not end.
        private static FluidMessage? NotPlaying(Behaviour simulation)
        {
            if (Application.isPlaying && simulation.isActiveAndEnabled) return null;
            return SceneObjects.IsPrefabAsset(simulation)
                ? new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                    "A prefab asset cannot run.", "Start an instance of it: what Instantiate returns, or one that is placed in a scene.")
                : Application.isPlaying
                ? new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                    "The component or its object is disabled, so the simulation cannot start.", "Enable both first.")
                : new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                    "Simulations run in play mode only.", "Press Play, or use FluidSolver directly in Editor tools.");
        }

        /// <summary>A failure that only the attempt showed.</summary>
        public static FluidMessage Failure(UnityEngine.Object simulation, Exception exception) => new FluidMessage(
            FluidSeverity.Error, exception is FluidDeviceException ? FluidIssue.DeviceUnsupported : FluidIssue.StartFailed,
            simulation, exception.Message, "");

        /// <summary>A liquid's time that goes backwards or has no end.</summary>
        public static FluidMessage TimeScaleInvalid(UnityEngine.Object simulation, float timeScale) => new FluidMessage(
            FluidSeverity.Error, FluidIssue.TimeScaleInvalid, simulation,
            FormattableString.Invariant($"Time Scale is {timeScale}, so the liquid stands still."),
            "Set Time Scale to 0 or more; 1 is as fast as the scene.");

        /// <summary>Rigid bodies that the liquid does not move.</summary>
        public static FluidMessage TooManyBodies(UnityEngine.Object simulation, int most) => new FluidMessage(
            FluidSeverity.Warning, FluidIssue.TooManyBodies, simulation,
            $"More than {most} Rigidbodies are in the domain, the most that the liquid moves: the others push it and feel nothing of it.",
            "Switch Moved By Liquid off in a Fluid Collider where the liquid need not move the body.");

        /// <summary>
        /// What to report when a run failed: a check names the setting and the cure; the failure itself is reported where no check knows of
        /// it.
        /// </summary>
        public static IEnumerable<FluidMessage> ErrorsOf(IReadOnlyList<FluidMessage> check, FluidMessage failure)
        {
            IReadOnlyList<FluidMessage> found = FluidChecks.HasErrors(check) ? check : new[] { failure };
            foreach (FluidMessage message in found)
                if (message.Severity == FluidSeverity.Error) yield return message;
        }
    }
}
