using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A method of computing the liquid's motion: passes recorded in the order of the paper.</summary>
    public interface IFluidMethod
    {
        /// <summary>Records what finds each particle's neighbours at its present position, and the density there.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="state">Buffers and settings.</param>
        void RecordNeighbourSetup(CommandBuffer cmd, FluidState state);

        /// <summary>Records the forces and the motion of one time step. The neighbour setup comes before it.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="state">Buffers and settings.</param>
        /// <param name="step">Length of this step and of the one before.</param>
        void RecordMotion(CommandBuffer cmd, FluidState state, in FluidStep step);

        /// <summary>Records the taking over of particles that were uploaded to <see cref="FluidBuffers.Particles"/>.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="state">Buffers and settings.</param>
        void RecordLoad(CommandBuffer cmd, FluidState state);

        /// <summary>Records what brings particles, density, pressure and grid indices of <see cref="FluidBuffers"/> up to the last neighbour setup, for drawing and measuring.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="state">Buffers and settings.</param>
        void RecordPublish(CommandBuffer cmd, FluidState state);

        /// <summary>Records what a kernel needs that includes the method's neighbour loop.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="state">Buffers and settings.</param>
        /// <param name="kernel">The kernel.</param>
        void BindNeighbours(CommandBuffer cmd, FluidState state, ComputeKernel kernel);
    }
}
