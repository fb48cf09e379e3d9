using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The liquids of a play as sequences: DIR, and where there are several DIR.1, DIR.2 and so on.</summary>
    internal sealed class PlaySequences
    {
        private readonly Dictionary<FluidSimulation, (FluidSequenceWriter writer, FluidSolver solver, double time)> written =
            new Dictionary<FluidSimulation, (FluidSequenceWriter, FluidSolver, double)>();

        /// <summary>
        /// Writes a liquid as it is now, if time has passed since it was written last. One that starts anew is not written further.
        /// </summary>
        public void Write(int index, FluidSimulation simulation, string folder)
        {
            bool isKnown = written.TryGetValue(simulation, out (FluidSequenceWriter writer, FluidSolver solver, double time) now);
            if (isKnown && (now.writer == null || simulation.SimulatedTime == now.time && simulation.Solver == now.solver)) return;
            try
            {
                if (!isKnown)
                {
                    now =
                        (new FluidSequenceWriter(index == 0 ? folder : $"{folder}.{index}", simulation.DomainSize, simulation.Spacing,
                            SourceOf(simulation)), simulation.Solver, 0.0);
                }
                if (simulation.Solver != now.solver || isKnown && simulation.SimulatedTime < now.time)
                {
                    now.writer.Dispose();
                    now.writer = null;
                    Debug.LogWarning(
                        $"{FluidMessage.Prefix} '{simulation.name}' started again or went back in time, so the sequence ends before that.",
                        simulation);
                }
                now.writer?.Write(simulation);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException ||
                exception is ArgumentException)
            {
                End(now.writer);
                now.writer = null;
                Debug.LogError($"{FluidMessage.Prefix} '{simulation.name}': the sequence could not be written further: {exception.Message}",
                    simulation);
            }
            now.time = simulation.SimulatedTime;
            written[simulation] = now;
        }

        private static void End(FluidSequenceWriter writer)
        {
            try
            {
                writer?.Dispose();
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                // Then sequence.json is of a moment before: it lists whole frames, and not all.
            }
        }

        /// <summary>Ends all of them.</summary>
        /// <exception cref="IOException">One cannot be written.</exception>
        public void Finish()
        {
            foreach ((FluidSequenceWriter writer, FluidSolver _, double _) in written.Values) writer?.Dispose();
        }

        private static string SourceOf(FluidSimulation simulation) => simulation.TryGetComponent(out FluidPlayback playback) &&
            playback.IsOpen
            ? playback.Source : $"SPH Fluid, method {CaseMethod.Of(simulation.ActiveMethod).Name}";
    }
}
