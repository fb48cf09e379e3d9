using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The fluid blocks of chapter 6 in their order, one pass each. Fluid Setup (6.2): CalculateParticleCellValue,
    /// BitonicSort (or the same sort fused), ResetGridIndices, SetGridIndices, SortParticles. SPH Calculations (6.3): CalculateDensity,
    /// CalculateForce, CalculateAcceleration, CalculateNewPosition.
    /// </summary>
    internal sealed class ThesisStepper : IFluidStepper
    {
        // The thesis itself asks what it is for.
        private const string OptionalPass = "ResetGridIndices";

        private readonly ThesisState state;
        private readonly CalculateParticleCellValuePass calculateParticleCellValue;
        private readonly BitonicSortPass bitonicSort;
        private readonly FusedBitonicSortPass fusedBitonicSort;
        private readonly ResetGridIndicesPass resetGridIndices;
        private readonly SetGridIndicesPass setGridIndices;
        private readonly SortParticlesPass sortParticles;
        private readonly CalculateDensityPass calculateDensity;
        private readonly CalculateForcePass calculateForce;
        private readonly CalculateAccelerationPass calculateAcceleration;
        private readonly CalculateNewPositionPass calculateNewPosition;

        public ThesisStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount)
        {
            calculateParticleCellValue = new CalculateParticleCellValuePass(shaders);
            bitonicSort = new BitonicSortPass(shaders);
            fusedBitonicSort = new FusedBitonicSortPass(shaders, bitonicSort);
            resetGridIndices = new ResetGridIndicesPass(shaders);
            setGridIndices = new SetGridIndicesPass(shaders);
            sortParticles = new SortParticlesPass(shaders);
            calculateDensity = new CalculateDensityPass(shaders);
            calculateForce = new CalculateForcePass(shaders);
            calculateAcceleration = new CalculateAccelerationPass(shaders);
            calculateNewPosition = new CalculateNewPositionPass(shaders);
            state = new ThesisState(settings, particleCount);
        }

        /// <summary>What the blocks work on.</summary>
        public ThesisState State => state;

        FluidState IFluidStepper.State => state;

        /// <inheritdoc/>
        public long SetupCount { get; private set; }

        /// <inheritdoc/>
        public void RecordLoad(CommandBuffer cmd)
        {
        }

        /// <inheritdoc/>
        public void RecordNeighbourSetup(CommandBuffer cmd) => RecordNeighbourSetup(cmd, true);

        /// <inheritdoc/>
        public int StepsPerSetup(int steps, float timeStep, float speed) => 1;

        /// <inheritdoc/>
        public void PlanSteps(int steps, float timeStep, float speed, float longest)
        {
        }

        /// <summary>Records the neighbour setup with one of its passes left out, to measure what the pass is for.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="pass">Name of the pass.</param>
        /// <exception cref="ArgumentException">No such pass can be left out.</exception>
        public void RecordNeighbourSetupWithout(CommandBuffer cmd, string pass)
        {
            if (pass != OptionalPass)
            {
                throw new ArgumentException(
                    $"The thesis method cannot leave out '{pass}' of the neighbour setup, only '{OptionalPass}'.", nameof(pass));
            }

            RecordNeighbourSetup(cmd, false);
        }

        private void RecordNeighbourSetup(CommandBuffer cmd, bool reset)
        {
            calculateParticleCellValue.Record(cmd, state);
            if (state.Own.FusedSort) fusedBitonicSort.Record(cmd, state);
            else bitonicSort.Record(cmd, state);
            if (reset) resetGridIndices.Record(cmd, state);
            setGridIndices.Record(cmd, state);
            sortParticles.Record(cmd, state);
            calculateDensity.Record(cmd, state);
            SetupCount++;
        }

        /// <inheritdoc/>
        public void RecordMotion(CommandBuffer cmd, in FluidStep step)
        {
            calculateForce.Record(cmd, state);
            calculateAcceleration.Record(cmd, state, step);
            calculateNewPosition.Record(cmd, state, step);
        }

        /// <inheritdoc/>
        public void RecordPublish(CommandBuffer cmd)
        {
        }

        /// <inheritdoc/>
        public void Dispose() => state.Dispose();
    }
}
