using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What steppers of methods with a counting sort share: loading, the sort, walls and contact, births and drains, and what readers see.
    /// </summary>
    internal abstract class CellStepper : IFluidStepper, IExchangingStepper
    {
        private readonly LoadParticlesPass loadParticles;
        private readonly ScanCellsPass scanCells;
        private readonly RankCellsPass rankCells;
        private readonly ScatterParticlesPass scatterParticles;
        private readonly FindContactsPass findContacts;
        private readonly ResolveContactsPass resolveContacts;
        private readonly PublishParticlesPass publishParticles;
        private SleepParticlesPass sleepParticles;
        private DrainParticlesPass drainParticles;
        private BirthParticlesPass birthParticles;
        private GrowParticlesPass growParticles;

        protected CellStepper(FluidShaderSet shaders)
        {
            Shaders = shaders;
            loadParticles = new LoadParticlesPass(Shaders);
            scanCells = new ScanCellsPass(Shaders);
            rankCells = new RankCellsPass(Shaders);
            scatterParticles = new ScatterParticlesPass(Shaders);
            GatherWalls = new GatherWallsPass(Shaders);
            MoveBodies = new MoveBodiesPass(Shaders);
            findContacts = new FindContactsPass(Shaders);
            resolveContacts = new ResolveContactsPass(Shaders);
            publishParticles = new PublishParticlesPass(Shaders);
        }

        /// <summary>What the buffers hold.</summary>
        protected enum ParticleOrder
        {
            /// <summary>Particles counted into cells.</summary>
            Counted,

            /// <summary>Sorted.</summary>
            Sorted,

            /// <summary>As a step left them, in the order of the last sort.</summary>
            Left,

            /// <summary>The same where the next step has begun.</summary>
            Kept,
        }

        FluidState IFluidStepper.State => Cells;

        /// <inheritdoc/>
        public long SetupCount { get; private set; }

        /// <summary>What the passes work on.</summary>
        protected abstract CellState Cells { get; }

        /// <summary>Where the particles are that drains are held against, in the order of the last sort.</summary>
        protected virtual FluidBuffer Places => Cells.Buffers.PositionTerms;

        /// <summary>The shaders, for passes that are made when they are needed.</summary>
        protected FluidShaderSet Shaders { get; }

        /// <summary>What the buffers hold.</summary>
        protected ParticleOrder Order { get; set; }

        /// <summary>The walls of triangles near each particle.</summary>
        protected GatherWallsPass GatherWalls { get; }

        /// <summary>Parts of the liquid that sleep.</summary>
        protected SleepParticlesPass Sleeping => sleepParticles ??= new SleepParticlesPass(Shaders);

        /// <summary>Bodies that the liquid moves.</summary>
        protected MoveBodiesPass MoveBodies { get; }

        /// <inheritdoc/>
        public virtual void RecordLoad(CommandBuffer cmd)
        {
            if (Cells.Sparse.AreUsed) rankCells.RecordLoad(cmd, Cells);
            loadParticles.Record(cmd, Cells);
            Cells.Wake(true);
            Order = ParticleOrder.Counted;
        }

        /// <inheritdoc/>
        public abstract int StepsPerSetup(int steps, float timeStep, float speed);

        /// <inheritdoc/>
        public abstract void PlanSteps(int steps, float timeStep, float speed, float longest);

        /// <inheritdoc/>
        public abstract void RecordNeighbourSetup(CommandBuffer cmd);

        /// <inheritdoc/>
        public abstract void RecordMotion(CommandBuffer cmd, in FluidStep step);

        /// <inheritdoc/>
        public virtual void Reserve(CommandBuffer cmd, int capacity)
        {
            growParticles ??= new GrowParticlesPass(Shaders);
            Cells.RequireList();
            var old = new CellRemains(Cells);
            Cells.Resize(capacity);
            if (cmd != null) growParticles.Record(cmd, Cells, old, Cells.ParticleCount);
        }

        /// <inheritdoc/>
        public void RecordDrains(CommandBuffer cmd, in DrainBatch drains)
        {
            drainParticles ??= new DrainParticlesPass(Shaders);
            drainParticles.Record(cmd, Cells, drains, Places);
        }

        /// <inheritdoc/>
        public void RecordBirths(CommandBuffer cmd, in BirthBatch births)
        {
            birthParticles ??= new BirthParticlesPass(Shaders);
            birthParticles.Record(cmd, Cells, births);
        }

        /// <inheritdoc/>
        public virtual void RecordPublish(CommandBuffer cmd)
        {
            publishParticles.Record(cmd, Cells);
            if (Cells.Sparse.AreUsed) rankCells.RecordPublish(cmd, Cells);
        }

        /// <inheritdoc/>
        public void Dispose() => Cells.Dispose();

        /// <summary>Sorts particles that are counted into cells; the scan uses up the counts.</summary>
        protected void Sort(CommandBuffer cmd)
        {
            if (Cells.Sparse.AreUsed) rankCells.Record(cmd, Cells);
            else scanCells.Record(cmd, Cells);
            scatterParticles.Record(cmd, Cells);
            if (Cells.HasSleepers) Sleeping.Record(cmd, Cells);
            Order = ParticleOrder.Sorted;
            SetupCount++;
        }

        /// <summary>Proves the motion of a step free of triangles, and changes what is not.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="step">The step.</param>
        /// <param name="from">Where it began, in the order of the particles.</param>
        protected void ProveMotion(CommandBuffer cmd, in FluidStep step, FluidBuffer from)
        {
            findContacts.Record(cmd, Cells, step, from);
            resolveContacts.Record(cmd, Cells, step);
        }
    }
}
