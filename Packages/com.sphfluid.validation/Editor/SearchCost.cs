using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using UnityEngine;

namespace SphFluid.Validation.Editor
{
    /// <summary>Time of a step with either neighbour search of the thesis method, taken in turns, on the console.</summary>
    public static class SearchCost
    {
        private const int Turns = 9;
        private const int StepsPerTurn = 4;

        /// <summary>Entry point for <c>-batchmode -executeMethod SphFluid.Validation.Editor.SearchCost.Write</c>.</summary>
        public static void Write()
        {
            FluidParticle[] start = SwitchCatalogue.Cube(24, out FluidSolverSettings octant);
            FluidSolverSettings rows = octant;
            rows.OctantSearch = false;
            using (var a = new FluidSolver(octant, SessionAssets.PackageShaders, start))
            using (var b = new FluidSolver(rows, SessionAssets.PackageShaders, start))
            {
                Time(a);
                Time(b);
                var octants = new List<double>();
                var cells = new List<double>();
                for (int turn = 0; turn < Turns; turn++)
                {
                    octants.Add(Time(a));
                    cells.Add(Time(b));
                }
                octants.Sort();
                cells.Sort();
                Console.WriteLine(string.Format(CultureInfo.InvariantCulture,
                    "{0}, {1} particles: 8 cells of 2h {2:0.0} ms a step ({3:0.0} to {4:0.0}), 27 cells of h {5:0.0} ms ({6:0.0} to " +
                    "{7:0.0})",
                    SystemInfo.graphicsDeviceName, start.Length, octants[Turns / 2], octants[0], octants[Turns - 1],
                    cells[Turns / 2], cells[0], cells[Turns - 1]));
            }
        }

        // Milliseconds a step.
        private static double Time(FluidSolver solver)
        {
            var watch = Stopwatch.StartNew();
            GpuWork.Step("Search Cost", solver, StepsPerTurn);
            solver.ReadCountersNow();
            return watch.Elapsed.TotalMilliseconds / StepsPerTurn;
        }
    }
}
