using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Steps a liquid by the Standard method in four dependent dispatches: ScanCells, Scatter, StandardDensity, MoveParticles;
    /// the stable order makes Scatter two. Triangles add three: GatherWalls before the density, FindContacts and ResolveContacts after
    /// the motion, and bodies that the liquid moves MoveBodies before the first and after the motion. A step that keeps the order and lists of an earlier one has two, ListedDensity and MoveParticles, and the same three of triangles.
    /// An implicit viscosity has several in the place of MoveParticles: KickParticles, DiffuseVelocities and DriftParticles.
    /// </summary>
    internal sealed class StandardStepper : IFluidStepper, IExchangingStepper
    {
        readonly StandardState state;
        readonly LoadParticlesPass loadParticles;
        readonly ScanCellsPass scanCells;
        readonly ScatterParticlesPass scatterParticles;
        readonly StandardDensityPass density;
        readonly MoveParticlesPass moveParticles;
        readonly GatherWallsPass gatherWalls;
        readonly MoveBodiesPass moveBodies;
        readonly FindContactsPass findContacts;
        readonly ResolveContactsPass resolveContacts;
        readonly PublishParticlesPass publishParticles;
        readonly FluidShaderSet shaders;
        KickParticlesPass kickParticles;
        DiffuseVelocitiesPass diffuseVelocities;
        DriftParticlesPass driftParticles;
        DrainParticlesPass drainParticles;
        BirthParticlesPass birthParticles;
        GrowParticlesPass growParticles;
        Order order;
        bool isLoaded;
        float listTime;

        // What the buffers hold: particles counted into cells, sorted, as a step left them in the order of the sort, the same where the
        // next step has begun.
        enum Order
        {
            Counted,
            Sorted,
            Left,
            Kept,
        }

        public StandardStepper(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount)
        {
            loadParticles = new LoadParticlesPass(shaders);
            scanCells = new ScanCellsPass(shaders);
            scatterParticles = new ScatterParticlesPass(shaders);
            density = new StandardDensityPass(shaders);
            moveParticles = new MoveParticlesPass(shaders);
            gatherWalls = new GatherWallsPass(shaders);
            moveBodies = new MoveBodiesPass(shaders);
            findContacts = new FindContactsPass(shaders);
            resolveContacts = new ResolveContactsPass(shaders);
            publishParticles = new PublishParticlesPass(shaders);
            this.shaders = shaders;
            state = new StandardState(settings, particleCount);
        }

        /// <summary>What the passes work on.</summary>
        public StandardState State => state;

        FluidState IFluidStepper.State => state;

        /// <inheritdoc/>
        public void RecordLoad(CommandBuffer cmd)
        {
            loadParticles.Record(cmd, state);
            order = Order.Counted;
            isLoaded = false;
        }

        /// <inheritdoc/>
        public int StepsPerSetup(int steps, float timeStep, float speed) => ListReuse.Steps(state, steps, timeStep, speed);

        /// <inheritdoc/>
        public void PlanSteps(int steps, float timeStep) => listTime = (steps - 1) * timeStep;

        /// <inheritdoc/>
        public void RecordNeighbourSetup(CommandBuffer cmd)
        {
            state.RequireList();
            if (order == Order.Counted) // the scan uses up the counts
            {
                state.ListTime = isLoaded ? listTime : 0f; // of particles just loaded nobody knows who stands at a surface
                scanCells.Record(cmd, state);
                scatterParticles.Record(cmd, state);
                order = Order.Sorted;
                isLoaded = true;
            }
            else if (order == Order.Left) // what the last step left is what this one begins with
            {
                FluidBuffer.Exchange(state.Buffers.Velocities, state.Buffers.NewVelocities);
                order = Order.Kept;
            }

            bool isKept = order == Order.Kept;
            if (state.HasBodies)
            {
                state.RequireWalls();
                if (state.HasFloatingBodies) moveBodies.RecordBegin(cmd, state);
                gatherWalls.Record(cmd, state, isKept ? state.Buffers.NewPositions : state.Buffers.Positions, isKept && !state.Bodies.IsUnderWay);
            }

            if (isKept) density.RecordListed(cmd, state);
            else density.Record(cmd, state);
        }

        /// <inheritdoc/>
        public void RecordNeighbourSetupWithout(CommandBuffer cmd, string pass) =>
            throw new ArgumentException($"The method Standard cannot leave out '{pass}' of the neighbour setup: it needs all of its passes.", nameof(pass));

        /// <inheritdoc/>
        public void RecordMotion(CommandBuffer cmd, in FluidStep step)
        {
            if (state.Own.ImplicitViscosity) RecordViscousMotion(cmd, step);
            else moveParticles.Record(cmd, state, step);
            if (state.HasBodies)
            {
                if (state.HasFloatingBodies) moveBodies.Record(cmd, state, step);
                findContacts.Record(cmd, state, step);
                resolveContacts.Record(cmd, state, step);
            }

            order = step.KeepsOrder ? Order.Left : Order.Counted;
        }

        void RecordViscousMotion(CommandBuffer cmd, in FluidStep step)
        {
            state.RequireViscous();
            kickParticles ??= new KickParticlesPass(shaders);
            diffuseVelocities ??= new DiffuseVelocitiesPass(shaders);
            driftParticles ??= new DriftParticlesPass(shaders);
            kickParticles.Record(cmd, state, step);
            diffuseVelocities.Record(cmd, state, step);
            driftParticles.Record(cmd, state, step);
        }

        /// <inheritdoc/>
        public void Reserve(CommandBuffer cmd, int capacity)
        {
            growParticles ??= new GrowParticlesPass(shaders);
            state.RequireList();
            var old = new StandardRemains(state);
            state.Resize(capacity);
            if (cmd != null) growParticles.Record(cmd, state, old, state.ParticleCount);
        }

        /// <inheritdoc/>
        public void RecordDrains(CommandBuffer cmd, in DrainBatch drains)
        {
            drainParticles ??= new DrainParticlesPass(shaders);
            drainParticles.Record(cmd, state, drains);
        }

        /// <inheritdoc/>
        public void RecordBirths(CommandBuffer cmd, in BirthBatch births)
        {
            birthParticles ??= new BirthParticlesPass(shaders);
            birthParticles.Record(cmd, state, births);
        }

        /// <inheritdoc/>
        public void RecordPublish(CommandBuffer cmd) => publishParticles.Record(cmd, state);

        /// <inheritdoc/>
        public void Dispose() => state.Dispose();
    }
}
