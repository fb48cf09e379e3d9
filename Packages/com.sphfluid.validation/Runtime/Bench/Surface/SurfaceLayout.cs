using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Surfaces alone: what field, mesh and drawing cost, against the thesis's and the dense compute one on the same grid.
    /// </summary>
    public sealed class SurfaceLayout : BenchLayout
    {
        private readonly string[] parts;

        /// <summary>The form for some parts of a surface.</summary>
        /// <param name="parts">Names of the parts, a column each.</param>
        public SurfaceLayout(IEnumerable<string> parts) : base("surface")
        {
            this.parts = parts.ToArray();
            Format
                .Text("surface", row => row.Config.Surface)
                .Text("field", row => row.Config.Field)
                .Count("particles", row => row.Particles)
                .Count("grid", row => row.Surface.Cells)
                .Number("cell", row => row.Surface.CellSize)
                .Number("spacing", row => row.Spacing)
                .Number("support", row => row.Support)
                .Number("neighbours_mean", row => row.NeighboursMean);
            AddTimes();
            AddParts("gpu_ms.", this.parts, (row, i) => row.Block(i));
            Format
                .Number("blocks_over_frame", row => row.BlocksOverStep)
                .Number("neighbours_ms", row => row.NeighbourSetup)
                .Text("triangles", row => Text(Counted(row).Triangles))
                .Text("vertices", row => Text(Counted(row).Vertices))
                .Text("blocks_active", row => Text(row.Surface.ActiveBlocks))
                .Text("blocks_potential", row => Text(row.Surface.PotentialBlocks))
                .Text("gpu_bytes", row => Text(row.Surface.GpuBytes))
                .Number("speedup_gs", row => SpeedUp(row, BenchSurfaceKind.Geometry))
                .Number("speedup_dense", row => SpeedUp(row, BenchSurfaceKind.DenseCompute))
                .Number("over_half_grid", OverHalfGrid);
            AddSamples()
                .Text("note", row => row.Note);
        }

        /// <inheritdoc/>
        public override string Head =>
            $"{"",-20}{"particles",10}{"cells",7}{"GPU ms",10}{string.Concat(parts.Select(p => $"{p,9}"))}{"triangles",11}{"blocks",14}" +
            $"{"MB",8}{"over gs",9}{"dense",8}{"half",7}";

        /// <inheritdoc/>
        public override string Line(BenchRow row)
        {
            BenchSurfaceFacts facts = row.Surface;
            string times = string.Concat(parts.Select((_, i) => string.Format(CultureInfo.InvariantCulture, "{0,9:F3}", row.Block(i))));
            string blocks = facts.ActiveBlocks.HasValue ? $"{facts.ActiveBlocks}/{facts.PotentialBlocks}" : "";
            return string.Format(CultureInfo.InvariantCulture, "{0,-20}{1,10}{2,7}{3,10:F3}{4}{5,11}{6,14}{7,8:F1}{8,9}{9,8}{10,7}  {11}",
                row.Config.Title, row.Particles, facts.Cells, row.Frame.Median, times, Text(Counted(row).Triangles), blocks,
                facts.GpuBytes * 1e-6,
                Short(SpeedUp(row, BenchSurfaceKind.Geometry)), Short(SpeedUp(row, BenchSurfaceKind.DenseCompute)),
                Short(OverHalfGrid(row)), row.Note);
        }

        private static string Text(long? value) => value?.ToString(CultureInfo.InvariantCulture) ?? "";

        // The geometry shader's triangles cannot be counted; those of the dense compute surface are the same.
        private static BenchSurfaceFacts Counted(BenchRow row) =>
            row.Config.Kind == BenchSurfaceKind.Geometry ? Find(row, BenchSurfaceKind.DenseCompute, row.Surface.Cells)?.Surface ?? default
                : row.Surface;

        // How many times faster than another surface with the thesis's field on the same grid; not a number where that was not measured.
        private static double SpeedUp(BenchRow row, BenchSurfaceKind than) =>
            Find(row, than, row.Surface.Cells)?.Frame.Median / row.Frame.Median ?? double.NaN;

        // Time over the time of the same surface with half the cells a side.
        private static double OverHalfGrid(BenchRow row) =>
            row.Frame.Median / Find(row, row.Config.Kind, row.Surface.Cells / 2)?.Frame.Median ?? double.NaN;

        private static BenchRow Find(BenchRow row, BenchSurfaceKind kind, int cells) =>
            row.Config.Quality.HasValue ? null : row.Peers.FirstOrDefault(
            r => r.Config.Kind == kind && !r.Config.Quality.HasValue && r.Particles == row.Particles && r.Surface.Cells == cells &&
                r.IsMeasured);
    }
}
