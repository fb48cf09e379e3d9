using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Steps a liquid by the Standard method in five dependent dispatches: ScanReduce, ScanApply, Scatter, StandardDensity, MoveParticles;
    /// the stable order makes Scatter two. Triangles add three: GatherWalls before the density, FindContacts and ResolveContacts after
    /// the motion.
    /// </summary>
    internal sealed class StandardStepper : IFluidStepper
    {
        readonly StandardState state;
        readonly LoadParticlesPass loadParticles;
        readonly ScanCellsPass scanCells;
        readonly ScatterParticlesPass scatterParticles;
        readonly StandardDensityPass density;
        readonly MoveParticlesPass moveParticles;
        readonly GatherWallsPass gatherWalls;
        readonly FindContactsPass findContacts;
        readonly ResolveContactsPass resolveContacts;
        readonly PublishParticlesPass publishParticles;
        bool sorted;

        public StandardStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount)
        {
            loadParticles = new LoadParticlesPass(shaders);
            scanCells = new ScanCellsPass(shaders);
            scatterParticles = new ScatterParticlesPass(shaders);
            density = new StandardDensityPass(shaders);
            moveParticles = new MoveParticlesPass(shaders);
            gatherWalls = new GatherWallsPass(shaders);
            findContacts = new FindContactsPass(shaders);
            resolveContacts = new ResolveContactsPass(shaders);
            publishParticles = new PublishParticlesPass(shaders);
            state = new StandardState(settings, particleCount);
        }

        /// <summary>What the passes work on.</summary>
        public StandardState State => state;

        FluidState IFluidStepper.State => state;

        /// <inheritdoc/>
        public void RecordLoad(CommandBuffer cmd)
        {
            loadParticles.Record(cmd, state);
            sorted = false;
        }

        /// <inheritdoc/>
        public void RecordNeighbourSetup(CommandBuffer cmd)
        {
            if (!sorted) // the scan uses up the counts
            {
                scanCells.Record(cmd, state);
                scatterParticles.Record(cmd, state);
                sorted = true;
            }

            if (state.HasBodies)
            {
                state.RequireWalls();
                gatherWalls.Record(cmd, state);
            }

            state.RequireList();
            density.Record(cmd, state);
        }

        /// <inheritdoc/>
        public void RecordNeighbourSetupWithout(CommandBuffer cmd, string pass) =>
            throw new ArgumentException($"The method Standard cannot leave out '{pass}' of the neighbour setup: it needs all of its passes.", nameof(pass));

        /// <inheritdoc/>
        public void RecordMotion(CommandBuffer cmd, in FluidStep step)
        {
            moveParticles.Record(cmd, state, step);
            if (state.HasBodies)
            {
                findContacts.Record(cmd, state);
                resolveContacts.Record(cmd, state, step.Length);
            }

            sorted = false;
        }

        /// <inheritdoc/>
        public void RecordPublish(CommandBuffer cmd) => publishParticles.Record(cmd, state);

        /// <inheritdoc/>
        public void Dispose() => state.Dispose();
    }
}
