using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Changes every simulation of the loaded scenes as the command line asks, before they start.</summary>
    internal static class PlayOverrides
    {
        public static void Apply(PlayArguments arguments, IReadOnlyList<FluidSimulation> simulations)
        {
            if (arguments.Sequence != null) SetSequence(arguments.Sequence, simulations);
            if (arguments.Budget != null && !simulations.Any(s => (arguments.Method ?? s.Method) == FluidMethodKind.Automatic))
            {
                throw new CommandLineException(
                    "--budget acts with --method automatic only, and no liquid of the scene has that method; give --method automatic, or " +
                    "no budget.");
            }
            FluidLiquid liquid = arguments.Liquid != null ? PackageLiquids.Load(arguments.Liquid) : null;
            foreach (FluidSimulation simulation in simulations)
            {
                if (liquid != null) SetLiquid(simulation, liquid);
                if (arguments.Method is FluidMethodKind method) simulation.Method = method;
                arguments.Profile?.Set(simulation);
                if (arguments.Budget is float budget) simulation.FrameBudget = budget;
                if (arguments.Particles is int count) SetParticles(simulation, count);
                if (arguments.Seed is int seed) simulation.Seed = seed;
                if (arguments.Surface == "none")
                {
                    Debug.Log(
                        $"{FluidMessage.Prefix} '{simulation.name}': --surface none: pictures show the scene without this liquid. " +
                        "--no-images makes none.");
                }
                if (arguments.Surface != null)
                    SetSurface(simulation, arguments.Surface);
                else if (SurfaceOf(simulation) == "none")
                    WarnUndrawn(simulation);
            }
        }

        // One sequence is one liquid, of the spacing and in the domain that it was made with; the floor of the domain stays where it is.
        private static void SetSequence(string folder, IReadOnlyList<FluidSimulation> simulations)
        {
            if (simulations.Count != 1)
            {
                throw new CommandLineException(
                    $"--sequence plays one liquid, and the scene has {simulations.Count} Fluid Simulations that are enabled.");
            }
            FluidSimulation simulation = simulations[0];
            if (!simulation.TryGetComponent(out FluidPlayback playback)) playback = simulation.gameObject.AddComponent<FluidPlayback>();
            playback.Folder = Path.GetFullPath(folder);
            playback.enabled = true;
            if (!playback.Reload()) throw new CommandLineException($"--sequence: {playback.Problem?.Text} {playback.Problem?.Cure}");
            float spacing = playback.SequenceSpacing;
            Vector3 size = playback.SequenceDomainSize, before = simulation.DomainSize;
            if (spacing == 0f || spacing == simulation.Spacing && size == before) return;
            Debug.Log(FormattableString.Invariant(
                $"{FluidMessage.Prefix} '{simulation.name}': the sequence was made with a spacing of {spacing} m in a domain of ") +
                FormattableString.Invariant($"{size.x} × {size.y} × {size.z} m, so the scene's {simulation.Spacing} m and {before.x} × ") +
                FormattableString.Invariant($"{before.y} × {before.z} m give way to these."));
            simulation.Spacing = spacing;
            simulation.DomainSize = size;
            simulation.transform.position += simulation.transform.rotation * new Vector3(0f, 0.5f * (size.y - before.y), 0f);
        }

        // Nothing of the scene's is to contradict it.
        private static void SetLiquid(FluidSimulation simulation, FluidLiquid liquid)
        {
            simulation.Liquid = liquid;
            simulation.Profile = null;
            foreach (FluidEmitter emitter in LoadedScenes.Find<FluidEmitter>(includeInactive: true))
                if (emitter.Simulation == simulation) emitter.Liquid = liquid;
            foreach (FluidSurfaceRenderer view in ViewsOf(simulation).OfType<FluidSurfaceRenderer>()) view.OwnLook = false;
            if (simulation.TryGetComponent(out FluidWhitewater whitewater)) whitewater.OwnLook = false;
        }

        private static void WarnUndrawn(FluidSimulation simulation) => Debug.LogWarning(
            $"{FluidMessage.Prefix} '{simulation.name}': No component draws this liquid: pictures show the scene without it. " +
            "Give --surface marching-cubes, or add a Fluid Surface Renderer to the object; --surface none says that it is meant.",
            simulation);

        /// <summary>What draws a simulation now, in the words of --surface.</summary>
        public static string SurfaceOf(FluidSimulation simulation)
        {
            foreach (FluidView view in ViewsOf(simulation))
            {
                if (view.isActiveAndEnabled) return NameOf(view);
            }
            return "none";
        }

        /// <summary>The components that show a simulation, disabled ones too.</summary>
        public static IEnumerable<FluidView> ViewsOf(FluidSimulation simulation) =>
            LoadedScenes.Find<FluidView>(includeInactive: true).Where(v => v.Simulation == simulation);

        // Before a lattice is made: one of far too many sites would take minutes.
        private static void SetParticles(FluidSimulation simulation, int count)
        {
            long most = simulation.ParticleLimit;
            if (count > most)
            {
                string owner = simulation.Profile != null && most == simulation.Profile.MaxParticles
                    ? $"the profile '{simulation.Profile.name}' allows {most} particles" : $"this device's buffers hold {most} particles";
                throw new CommandLineException(FormattableString.Invariant(
                    $"--particles {count} does not fit '{simulation.name}': {owner}. The largest count that fits is {most}."));
            }
            try
            {
                simulation.Spacing = simulation.SpacingForParticleCount(count);
            }
            catch (Exception exception) when (exception is InvalidOperationException || exception is ArgumentException)
            {
                throw new CommandLineException($"--particles: '{simulation.name}': {exception.Message}");
            }
        }

        private static string NameOf(FluidView view)
        {
            if (view is FluidParticleRenderer) return "particles";
            if (!(view is FluidGeometrySurfaceRenderer thesis) || thesis.UsesFallback) return "marching-cubes";
            return thesis.Style == FluidSurfaceStyle.Cubes ? "cubes" : "marching-cubes-gs";
        }

        private static void SetSurface(FluidSimulation simulation, string surface)
        {
            foreach (FluidView view in ViewsOf(simulation)) view.enabled = false;
            if (surface == "particles")
                Enable<FluidParticleRenderer>(simulation);
            else if (surface == "marching-cubes")
                Enable<FluidSurfaceRenderer>(simulation);
            else if (surface == "cubes")
                Enable<FluidGeometrySurfaceRenderer>(simulation).Style = FluidSurfaceStyle.Cubes;
            else if (surface == "marching-cubes-gs")
                Enable<FluidGeometrySurfaceRenderer>(simulation).Style = FluidSurfaceStyle.MarchingCubes;
        }

        private static T Enable<T>(FluidSimulation simulation) where T : FluidView
        {
            foreach (FluidView view in ViewsOf(simulation))
            {
                if (view is T found)
                {
                    found.enabled = true;
                    return found;
                }
            }
            var added = simulation.gameObject.AddComponent<T>();
            added.Simulation = simulation;
            return added;
        }
    }
}
