using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Starts a simulation.</summary>
    internal static class FluidStarter
    {
        /// <summary>Checks the simulation and starts it.</summary>
        /// <param name="asked">The simulation; its method may be chosen here.</param>
        /// <param name="volumes">Its liquid volumes, in hierarchy order.</param>
        /// <param name="watch">Watches a start that takes long.</param>
        /// <param name="report">Receives what is wrong or worth knowing.</param>
        /// <returns>Null when an error was reported.</returns>
        public static FluidRun TryStart(in FluidSpec asked, IReadOnlyList<VolumeSpec> volumes, in StartWatch watch,
            Action<FluidMessage> report)
        {
            var collision = new CollisionScene();
            List<FluidMessage> found = FluidChecks.Check(asked, volumes, collision, FluidSpawner.Fill, out FluidStart start, true);
            foreach (FluidMessage message in found) report(message);
            FluidSpec spec = start == null ? asked : start.Resolve(asked);
            if (start != null)
            {
                try
                {
                    return new FluidRun(spec, start, RelaxedStart.Particles(spec, start, collision, watch, report), collision, report);
                }
                catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
                {
                    report(FluidReports.Failure(spec.Owner, exception));
                }
                catch (OperationCanceledException)
                {
                    report(new FluidMessage(FluidSeverity.Warning, FluidIssue.StartRelaxation, spec.Owner,
                        "The start was ended before the liquid came to rest, so it does not run.",
                        "Start it again, or set Start Relaxation to None."));
                }
            }
            collision.Dispose();
            return null;
        }

        /// <summary>Checks the simulation and makes the liquid of a save.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="save">The save, of a liquid that can run in it.</param>
        /// <param name="report">Receives what is wrong or worth knowing.</param>
        /// <returns>Null when an error was reported.</returns>
        /// <exception cref="System.IO.InvalidDataException">A section of the save is not what it should be.</exception>
        public static FluidRun TryContinue(in FluidSpec spec, FluidSave save, Action<FluidMessage> report)
        {
            var collision = new CollisionScene();
            List<FluidMessage> found = FluidChecks.CheckAgain(spec, collision, save.Start);
            foreach (FluidMessage message in found) report(message);
            FluidRun run = null;
            bool goesOn = false;
            try
            {
                if (FluidChecks.HasErrors(found)) return null;
                run = new FluidRun(spec, save.Start, save.Live, collision, report);
                run.Continue(spec, save);
                goesOn = true;
                return run;
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
            {
                report(FluidReports.Failure(spec.Owner, exception));
                return null;
            }
            finally
            {
                if (!goesOn && run != null) run.Dispose();
                else if (!goesOn) collision.Dispose();
            }
        }
    }
}
