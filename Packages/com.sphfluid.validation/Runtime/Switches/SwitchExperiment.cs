using System;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A small liquid whose end shows what one printed form of the thesis does beside the corrected one.</summary>
    public sealed class SwitchExperiment
    {
        private const string CommandName = "Switch Experiment";

        internal SwitchExperiment(string name, FluidParticle[] start, float seconds, in FluidSolverSettings corrected,
            in FluidSolverSettings printed)
        {
            Name = name;
            Start = start;
            Seconds = seconds;
            Corrected = corrected;
            Printed = printed;
        }

        /// <summary>Name of the experiment and of its picture, for instance "self-density".</summary>
        public string Name { get; }

        /// <summary>Particles at the start.</summary>
        public FluidParticle[] Start { get; }

        /// <summary>Length of the run [s].</summary>
        public float Seconds { get; }

        /// <summary>Constants with everything else as in the printed run.</summary>
        public FluidSolverSettings Corrected { get; }

        /// <summary>Constants with one thing as printed.</summary>
        public FluidSolverSettings Printed { get; }

        /// <summary>The picture looks down; otherwise along z.</summary>
        public bool FromAbove { get; internal set; }

        /// <summary>What the picture shows by colour.</summary>
        public SwitchColor Color { get; internal set; }

        /// <summary>The printed run takes 8 cells although its cells are h wide: the octant rule of 6.2 with the wrong size.</summary>
        internal bool EightCellsOfSmoothLength { get; set; }

        /// <summary>Runs one side.</summary>
        /// <param name="printed">The printed side, else the corrected one.</param>
        /// <param name="shaders">The compute shaders.</param>
        /// <returns>The end.</returns>
        public SwitchResult Run(bool printed, FluidShaderSet shaders)
        {
            FluidSolverSettings settings = printed ? Printed : Corrected;
            using (var solver = new FluidSolver(settings, shaders, Start))
            {
                if (printed && EightCellsOfSmoothLength)
                {
                    FluidSolverSettings wrong = settings;
                    wrong.OctantSearch = true;
                    SolverLaboratory.SetUnchecked(solver, wrong);
                }
                GpuWork.Step(CommandName, solver, (int)Math.Round(Seconds / settings.TimeStep));
                GpuWork.Submit(CommandName, cmd => solver.RecordNeighbourSetup(cmd));
                return new SwitchResult(solver);
            }
        }
    }
}
