using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Mean pressures on rectangles of a run's walls between its samples.</summary>
    internal sealed class CaseWalls
    {
        private readonly FluidSolver solver;
        private readonly WallPatch[] patches;
        private readonly double[] impulses, seconds; // at the last reading

        /// <summary>Rectangles; none where the method does not measure the force on walls.</summary>
        public CaseWalls(FluidSolver solver, IReadOnlyList<CasePatch> asked)
        {
            this.solver = solver;
            patches = new WallPatch[solver.MeasuresWallForces ? asked.Count : 0];
            impulses = new double[patches.Length];
            seconds = new double[patches.Length];
            for (int i = 0; i < patches.Length; i++) patches[i] = solver.WallForces.Add(asked[i].Centre, asked[i].Rotation, asked[i].Size);
        }

        /// <summary>
        /// Mean force per area since the last call [Pa], not a number where no step was done since; empty where the method measures none.
        /// </summary>
        public IReadOnlyList<double> Read()
        {
            if (patches.Length == 0) return Array.Empty<double>();
            solver.WallForces.Complete();
            var pressures = new double[patches.Length];
            for (int i = 0; i < patches.Length; i++)
            {
                pressures[i] = (patches[i].Impulse - impulses[i]) / (patches[i].Seconds - seconds[i]) / patches[i].Area;
                (impulses[i], seconds[i]) = (patches[i].Impulse, patches[i].Seconds);
            }
            return pressures;
        }
    }
}
