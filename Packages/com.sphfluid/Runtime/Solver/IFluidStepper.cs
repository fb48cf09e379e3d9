using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A method at work on one liquid: its buffers, and its passes in the order of the paper.</summary>
    internal interface IFluidStepper : IDisposable
    {
        /// <summary>What the passes work on.</summary>
        FluidState State { get; }

        /// <summary>Times that an order of the particles was recorded since the start.</summary>
        long SetupCount { get; }

        /// <summary>Records the taking over of particles that were uploaded to <see cref="PublishedBuffers.Particles"/>.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        void RecordLoad(CommandBuffer cmd);

        /// <summary>Records what finds each particle's neighbours at its present position, and the density there.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        void RecordNeighbourSetup(CommandBuffer cmd);

        /// <summary>Most steps that one neighbour setup may serve; 1 for a method that sets up neighbours for every step.</summary>
        /// <param name="steps">Steps that are to be taken at once.</param>
        /// <param name="timeStep">Length of each [s].</param>
        /// <param name="speed">Speed at which the liquid moves [m/s].</param>
        int StepsPerSetup(int steps, float timeStep, float speed);

        /// <summary>Announces how many steps the neighbour setups from now on serve.</summary>
        /// <param name="steps">Number of steps.</param>
        /// <param name="timeStep">Length of each [s].</param>
        /// <param name="speed">Speed of the fastest particle [m/s].</param>
        /// <param name="longest">The longest step of late, no less than <paramref name="timeStep"/> [s].</param>
        void PlanSteps(int steps, float timeStep, float speed, float longest);

        /// <summary>Records the forces and the motion of one time step. The neighbour setup comes before it.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="step">Length of this step and of the one before.</param>
        void RecordMotion(CommandBuffer cmd, in FluidStep step);

        /// <summary>
        /// Records what brings <see cref="FluidState.Published"/> up to the last neighbour setup, for drawing and measuring.
        /// </summary>
        /// <param name="cmd">Command buffer to record into.</param>
        void RecordPublish(CommandBuffer cmd);
    }
}
