using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Surfaces alone: what field, mesh and drawing cost, against the thesis's and the dense compute one on the same grid.</summary>
    public sealed class SurfaceLayout : IBenchLayout
    {
        readonly string[] parts;

        /// <summary>The form for some parts of a surface.</summary>
        /// <param name="parts">Names of the parts, a column each.</param>
        public SurfaceLayout(IEnumerable<string> parts)
        {
            this.parts = parts.ToArray();
            var columns = new List<BenchColumn>
            {
                new BenchColumn("table", (table, row) => table.Name),
                new BenchColumn("device", (table, row) => table.Device),
                new BenchColumn("config", row => row.Config.Name),
                new BenchColumn("method", row => row.Config.Solver.MethodName),
                new BenchColumn("surface", row => row.Config.Surface),
                new BenchColumn("field", row => row.Config.Field),
                new BenchColumn("particles", row => CsvText.Text(row.Particles)),
                new BenchColumn("grid", row => CsvText.Text(row.Surface.Cells)),
                new BenchColumn("cell", row => CsvText.Text(row.Surface.CellSize)),
                new BenchColumn("spacing", row => CsvText.Text(row.Spacing)),
                new BenchColumn("support", row => CsvText.Text(row.Support)),
                new BenchColumn("neighbours_mean", row => CsvText.Text(row.NeighboursMean)),
                new BenchColumn("dispatches", row => CsvText.Text(row.Dispatches)),
                new BenchColumn("gpu_ms_median", row => CsvText.Text(row.Frame.Median)),
                new BenchColumn("gpu_ms_min", row => CsvText.Text(row.Frame.Minimum)),
                new BenchColumn("gpu_ms_max", row => CsvText.Text(row.Frame.Maximum)),
            };
            columns.AddRange(this.parts.Select((name, i) => new BenchColumn("gpu_ms." + name, row => CsvText.Text(row.Block(i)))));
            columns.AddRange(new[]
            {
                new BenchColumn("blocks_over_frame", row => CsvText.Text(row.BlocksOverStep)),
                new BenchColumn("neighbours_ms", row => CsvText.Text(row.NeighbourSetup)),
                new BenchColumn("triangles", (table, row) => Text(Counted(table, row).Triangles)),
                new BenchColumn("vertices", (table, row) => Text(Counted(table, row).Vertices)),
                new BenchColumn("blocks_active", row => Text(row.Surface.ActiveBlocks)),
                new BenchColumn("blocks_potential", row => Text(row.Surface.PotentialBlocks)),
                new BenchColumn("gpu_bytes", row => Text(row.Surface.GpuBytes)),
                new BenchColumn("speedup_gs", (table, row) => CsvText.Text(SpeedUp(table, row, BenchSurfaceKind.Geometry))),
                new BenchColumn("speedup_dense", (table, row) => CsvText.Text(SpeedUp(table, row, BenchSurfaceKind.DenseCompute))),
                new BenchColumn("over_half_grid", (table, row) => CsvText.Text(OverHalfGrid(table, row))),
                new BenchColumn("samples", row => CsvText.Text(row.SampleCount)),
                new BenchColumn("frames", row => CsvText.Text(row.FrameCount)),
                new BenchColumn("date", (table, row) => table.Date),
                new BenchColumn("note", row => row.Note),
            });
            Columns = columns;
        }

        /// <inheritdoc/>
        public IReadOnlyList<BenchColumn> Columns { get; }

        /// <inheritdoc/>
        public string Head =>
            $"{"",-20}{"particles",10}{"cells",7}{"GPU ms",10}{string.Concat(parts.Select(p => $"{p,9}"))}{"triangles",11}{"blocks",14}{"MB",8}{"over gs",9}{"dense",8}{"half",7}";

        /// <inheritdoc/>
        public string Line(BenchTable table, BenchRow row)
        {
            BenchSurfaceFacts facts = row.Surface;
            string times = string.Concat(parts.Select((_, i) => string.Format(CultureInfo.InvariantCulture, "{0,9:F3}", row.Block(i))));
            string blocks = facts.ActiveBlocks.HasValue ? $"{facts.ActiveBlocks}/{facts.PotentialBlocks}" : "";
            return string.Format(CultureInfo.InvariantCulture, "{0,-20}{1,10}{2,7}{3,10:F3}{4}{5,11}{6,14}{7,8:F1}{8,9}{9,8}{10,7}  {11}",
                row.Config.Title, row.Particles, facts.Cells, row.Frame.Median, times, Text(Counted(table, row).Triangles), blocks, facts.GpuBytes * 1e-6,
                Short(SpeedUp(table, row, BenchSurfaceKind.Geometry)), Short(SpeedUp(table, row, BenchSurfaceKind.DenseCompute)),
                Short(OverHalfGrid(table, row)), row.Note);
        }

        static string Text(long? value) => value?.ToString(CultureInfo.InvariantCulture) ?? "";

        static string Short(double value) => double.IsNaN(value) ? "" : value.ToString("F2", CultureInfo.InvariantCulture);

        // The geometry shader's triangles cannot be counted; those of the dense compute surface are the same.
        static BenchSurfaceFacts Counted(BenchTable table, BenchRow row) =>
            row.Config.Kind == BenchSurfaceKind.Geometry ? Find(table, row, BenchSurfaceKind.DenseCompute, row.Surface.Cells)?.Surface ?? default : row.Surface;

        // How many times faster than another surface with the thesis's field on the same grid; not a number where that was not measured.
        static double SpeedUp(BenchTable table, BenchRow row, BenchSurfaceKind than) => Find(table, row, than, row.Surface.Cells)?.Frame.Median / row.Frame.Median ?? double.NaN;

        // Time over the time of the same surface with half the cells a side.
        static double OverHalfGrid(BenchTable table, BenchRow row) => row.Frame.Median / Find(table, row, row.Config.Kind, row.Surface.Cells / 2)?.Frame.Median ?? double.NaN;

        static BenchRow Find(BenchTable table, BenchRow row, BenchSurfaceKind kind, int cells) => row.Config.Quality.HasValue ? null : table.Rows.FirstOrDefault(
            r => r.Config.Kind == kind && !r.Config.Quality.HasValue && r.Particles == row.Particles && r.Surface.Cells == cells && r.SampleCount > 0);
    }
}
