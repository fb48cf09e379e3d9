using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>
    /// The sparse surface of a component: made anew when the liquid or the options changed. Messages name the component.
    /// </summary>
    internal sealed class SurfaceSource : IDisposable
    {
        private readonly CommandBuffer cmd = new CommandBuffer { name = "Fluid Surface" };
        private FluidSolver solver;
        private Content requested;
        private Content made;
        private string reported;

        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public SurfaceSource(FluidShaderSet shaders)
        {
            Surface = new SparseSurface(shaders);
        }

        public SparseSurface Surface { get; }

        /// <summary>Edge of a cell over that of the options, 1 or more; as far as cells may be so large.</summary>
        public float CellFactor { get; set; } = 1f;

        /// <summary>Grid of the last surface.</summary>
        public SurfaceGrid Grid => requested.Grid;

        /// <summary>The particles that left the surface, after <see cref="Make"/>; only where they may.</summary>
        public SprayBuffers Spray =>
            new SprayBuffers(Surface.Spray.Particles, Surface.Spray.DrawArguments, requested.Drops, requested.Field.Spacing);

        // With buffers that turn out too small it is made again until all of it fits; each attempt waits for the answer to the one before.
        private bool IsUpToDate => made.Equals(requested) && (Surface.IsSettled || Surface.IsAwaited);

        /// <summary>
        /// Takes what is to be shown: the particles' present positions. The buffers stay the same until the next call;
        /// <see cref="Make"/> fills them.
        /// </summary>
        /// <param name="liquid">The particles.</param>
        /// <param name="options">How the surface is made.</param>
        /// <param name="drops">Drops that a particle without company becomes; 0: it stays in the surface.</param>
        /// <param name="owner">Component that messages name.</param>
        /// <param name="buffers">The surface, after <see cref="Make"/>.</param>
        /// <returns>False after a message if the options cannot be met.</returns>
        /// <exception cref="FluidDeviceException">The device cannot hold the surface.</exception>
        public bool Request(FluidSolver liquid, FluidSurfaceOptions options, int drops, Object owner, out SurfaceBuffers buffers)
        {
            buffers = default;
            if (!TryField(liquid.Settings, options, owner, out SurfaceFieldSettings field, out SurfaceGrid grid)) return false;
            solver = liquid;
            requested = new Content(liquid, field.WithSpray(drops > 0), grid, options, drops);
            Surface.TriangleBudget = options.TriangleBudget;
            if (!IsUpToDate) Surface.Reserve(liquid, requested.Field, grid);
            Surface.SprayVertices = drops * SprayBuffers.VerticesPerDrop;
            for (string warning = Surface.TakeWarning(); warning != null; warning = Surface.TakeWarning())
            {
                Debug.LogWarning($"{FluidMessage.Prefix} '{owner.name}': {warning}", owner);
            }
            buffers = new SurfaceBuffers(Surface.Vertices, Surface.Indices, Surface.DrawArguments);
            return true;
        }

        /// <summary>Records and executes the requested surface, if the buffers do not hold it already.</summary>
        /// <returns>Whether there was anything to do.</returns>
        public bool Make()
        {
            if (solver == null || solver.IsDisposed || IsUpToDate) return false;
            cmd.Clear();
            Surface.RecordReserved(cmd, solver, requested.Field, requested.Grid, requested.Walls);
            Graphics.ExecuteCommandBuffer(cmd);
            made = requested;
            return true;
        }

        public void Dispose()
        {
            solver = null;
            cmd.Dispose();
            Surface.Dispose();
        }

        // What a surface shows. A field follows from the options and from the settings of the liquid, whose every change
        // is another version.
        private readonly struct Content : IEquatable<Content>
        {
            private readonly FluidSolver solver;
            private readonly long version;
            private readonly FluidSurfaceQuality quality;
            private readonly float cellSize;
            private readonly int budget;

            public Content(FluidSolver solver, in SurfaceFieldSettings field, SurfaceGrid grid, FluidSurfaceOptions options, int drops)
            {
                this.solver = solver;
                version = solver.StateVersion;
                quality = options.Quality;
                cellSize = options.CellSize;
                budget = options.TriangleBudget;
                Drops = drops;
                Field = field;
                Grid = grid;
                Walls = options.Walls;
            }

            public SurfaceFieldSettings Field { get; }

            public SurfaceGrid Grid { get; }

            public SurfaceWalls Walls { get; }

            public int Drops { get; }

            public bool Equals(Content other) => solver == other.solver && version == other.version && quality == other.quality &&
                cellSize == other.cellSize && budget == other.budget && Drops == other.Drops && Walls == other.Walls &&
                Grid.Equals(other.Grid);
        }

        // A cell size that cannot be met is reported once, until it is changed.
        private bool TryField(in FluidSolverSettings settings, FluidSurfaceOptions options, Object owner,
            out SurfaceFieldSettings field, out SurfaceGrid grid)
        {
            grid = default;
            field = default;
            try
            {
                field = options.Field(settings, CellFactor);
                grid = SurfaceGrid.OverDomain(settings.DomainSize, field.CellSize);
                reported = null;
                return true;
            }
            catch (ArgumentOutOfRangeException exception)
            {
                Report(WithoutParameter(exception), owner);
                return false;
            }
        }

        // Runtimes add the parameter's name, in brackets or on a line of its own.
        private static string WithoutParameter(ArgumentException exception)
        {
            string line = exception.Message.Split('\n')[0];
            int name = line.IndexOf(" (Parameter '", StringComparison.Ordinal);
            return (name < 0 ? line : line.Substring(0, name)).TrimEnd();
        }

        private void Report(string problem, Object owner)
        {
            if (problem == reported) return;
            reported = problem;
            Debug.LogError(
                $"{FluidMessage.Prefix} '{owner.name}': {problem} Choose another cell size or quality of the surface; until then the " +
                "liquid is not drawn.", owner);
        }
    }
}
