using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>
    /// The sparse surface of a component: made anew each frame as its options say. Messages name the component.
    /// </summary>
    sealed class SurfaceSource : IDisposable
    {
        readonly CommandBuffer cmd = new CommandBuffer { name = "Fluid Surface" };
        string reported;

        /// <exception cref="FluidDeviceException">The device cannot run a kernel.</exception>
        public SurfaceSource(FluidShaderSet shaders)
        {
            Surface = new SparseSurface(shaders);
        }

        public SparseSurface Surface { get; }

        /// <summary>Grid of the last surface.</summary>
        public SurfaceGrid Grid { get; private set; }

        /// <summary>Records and executes the surface of the particles' present positions.</summary>
        /// <param name="solver">The particles.</param>
        /// <param name="options">How the surface is made.</param>
        /// <param name="owner">Component that messages name.</param>
        /// <param name="buffers">The surface.</param>
        /// <returns>False after a message if the options cannot be met.</returns>
        /// <exception cref="FluidDeviceException">The device cannot hold the surface.</exception>
        public bool Update(FluidSolver solver, FluidSurfaceOptions options, Object owner, out SurfaceBuffers buffers)
        {
            buffers = default;
            if (!TryField(solver.Settings, options, owner, out SurfaceFieldSettings field, out SurfaceGrid grid))
                return false;
            Grid = grid;
            cmd.Clear();
            Surface.TriangleBudget = options.TriangleBudget;
            Surface.Record(cmd, solver, field, grid, options.Walls);
            Graphics.ExecuteCommandBuffer(cmd);
            for (string warning = Surface.TakeWarning(); warning != null; warning = Surface.TakeWarning())
                Debug.LogWarning($"{FluidMessage.Prefix} '{owner.name}': {warning}", owner);
            buffers = new SurfaceBuffers(Surface.Vertices, Surface.Indices, Surface.DrawArguments);
            return true;
        }

        public void Dispose()
        {
            cmd.Dispose();
            Surface.Dispose();
        }

        // A cell size that cannot be met is reported once, until it is changed.
        bool TryField(in FluidSolverSettings settings, FluidSurfaceOptions options, Object owner,
            out SurfaceFieldSettings field, out SurfaceGrid grid)
        {
            grid = default;
            field = default;
            try
            {
                field = options.Field(settings);
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
        static string WithoutParameter(ArgumentException exception)
        {
            string line = exception.Message.Split('\n')[0];
            int name = line.IndexOf(" (Parameter '", StringComparison.Ordinal);
            return (name < 0 ? line : line.Substring(0, name)).TrimEnd();
        }

        void Report(string problem, Object owner)
        {
            if (problem == reported)
                return;
            reported = problem;
            Debug.LogError(
                $"{FluidMessage.Prefix} '{owner.name}': {problem} Choose another cell size or quality of the surface; until then the liquid is not drawn.", owner);
        }
    }
}
