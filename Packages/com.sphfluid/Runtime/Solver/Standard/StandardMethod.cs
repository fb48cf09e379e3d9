using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Weakly compressible SPH with one Wendland C2 kernel for density and force, walls that carry density, and five dependent
    /// dispatches a step: ScanReduce, ScanApply, Scatter, StandardDensity, MoveParticles; the stable order makes Scatter two.
    /// Triangles add three: GatherWalls before the density, FindContacts and ResolveContacts after the motion.
    /// </summary>
    internal sealed class StandardMethod : IFluidMethod
    {
        readonly LoadParticlesPass loadParticles;
        readonly ScanCellsPass scanCells;
        readonly ScatterParticlesPass scatterParticles;
        readonly StandardDensityPass density;
        readonly MoveParticlesPass moveParticles;
        readonly GatherWallsPass gatherWalls;
        readonly ContactPass contacts;
        readonly PublishParticlesPass publishParticles;
        bool sorted;

        public StandardMethod(FluidShaderSet shaders)
        {
            loadParticles = new LoadParticlesPass(shaders);
            scanCells = new ScanCellsPass(shaders);
            scatterParticles = new ScatterParticlesPass(shaders);
            density = new StandardDensityPass(shaders);
            moveParticles = new MoveParticlesPass(shaders);
            gatherWalls = new GatherWallsPass(shaders);
            contacts = new ContactPass(shaders);
            publishParticles = new PublishParticlesPass(shaders);
        }

        /// <inheritdoc/>
        public void RecordLoad(CommandBuffer cmd, FluidState state)
        {
            loadParticles.Record(cmd, state);
            sorted = false;
        }

        /// <inheritdoc/>
        public void RecordNeighbourSetup(CommandBuffer cmd, FluidState state)
        {
            if (!sorted) // the scan uses up the counts
            {
                scanCells.Record(cmd, state);
                scatterParticles.Record(cmd, state);
                sorted = true;
            }

            if (state.HasBodies)
            {
                state.Standard.RequireWalls();
                gatherWalls.Record(cmd, state);
            }

            state.Standard.RequireList(state.Settings);
            density.Record(cmd, state);
        }

        /// <inheritdoc/>
        public void RecordMotion(CommandBuffer cmd, FluidState state, in FluidStep step)
        {
            moveParticles.Record(cmd, state, step);
            if (state.HasBodies)
            {
                contacts.Record(cmd, state, step.Length);
            }

            sorted = false;
        }

        /// <inheritdoc/>
        public void RecordPublish(CommandBuffer cmd, FluidState state)
        {
            publishParticles.Record(cmd, state);
        }

        /// <inheritdoc/>
        public void BindNeighbours(CommandBuffer cmd, FluidState state, ComputeKernel kernel)
        {
            GridNeighbours.SetNeighbours(cmd, kernel, state);
        }
    }
}
