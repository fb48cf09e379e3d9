using SphFluid.Laboratory;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// The sparse surface, drawn indirectly from its buffers: field and marching cubes only in blocks that hold the surface.
    /// </summary>
    internal sealed class SparseBenchSurface : IBenchSurface
    {
        private readonly SparseSurface surface;
        private readonly BenchMeshMaterial material;
        private readonly SurfaceGrid grid;
        private readonly SurfaceFieldSettings field;

        public SparseBenchSurface(FluidShaderSet shaders, in BenchConfig config, in FluidSolverSettings settings)
        {
            surface = new SparseSurface(shaders);
            material = new BenchMeshMaterial(BenchMeshMaterial.PackedVerticesPass);
            if (config.Quality is FluidSurfaceQuality quality)
            {
                field = SurfaceFieldSettings.For(quality, settings);
                grid = SurfaceGrid.OverDomain(settings.DomainSize, field.CellSize);
            }
            else
            {
                grid = BenchLiquid.SurfaceGrid(config.Grid);
                field = SurfaceFieldSettings.Thesis(settings, grid, BenchDrawing.IsoValue);
            }
        }

        public BenchSurfaceFacts Facts => FactsOf(surface, grid, 0);

        public bool HasCapacity => surface.Status.IsComplete;

        public void RecordTrial(CommandBuffer cmd, FluidSolver solver) => surface.Record(cmd, solver, field, grid, SurfaceWalls.Closed);

        public void TakeTrial() => surface.ReadStatus();

        public void Record(CommandBuffer cmd, FluidSolver solver, BenchDrawing drawing)
        {
            surface.Record(cmd, solver, field, grid, SurfaceWalls.Closed);
            drawing.BeginSurface(cmd);
            MaterialPropertyBlock properties = material.Properties(grid, surface.Vertices);
            cmd.DrawProceduralIndirect(surface.Indices, Matrix4x4.identity, material.Material, material.Pass, MeshTopology.Triangles,
                surface.DrawArguments, 0, properties);
            drawing.EndSurface(cmd);
        }

        /// <summary>Facts of a sparse surface.</summary>
        /// <param name="surface">The surface.</param>
        /// <param name="grid">Its grid.</param>
        /// <param name="drawingBytes">GPU memory of its drawing besides the mesh [bytes].</param>
        public static BenchSurfaceFacts FactsOf(SparseSurface surface, SurfaceGrid grid, long drawingBytes) => new BenchSurfaceFacts
        {
            Cells = grid.Cells.x,
            CellSize = grid.CellSize.x,
            Triangles = surface.Status.Triangles,
            Vertices = surface.Status.Vertices,
            ActiveBlocks = surface.Status.Blocks,
            PotentialBlocks = SparseFieldReader.BlocksOf(grid),
            GpuBytes = surface.GpuBytes + drawingBytes,
        };

        public void Dispose()
        {
            surface.Dispose();
            material.Dispose();
        }
    }
}
