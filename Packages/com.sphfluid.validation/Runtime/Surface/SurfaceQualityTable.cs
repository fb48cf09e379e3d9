using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>surface-quality.csv: a line for each variant of each state.</summary>
    sealed class SurfaceQualityTable
    {
        public const string FileName = "surface-quality.csv";

        static readonly (string Name, Func<SurfaceQuality, double> Value)[] columns =
        {
            ("particles", q => q.Particles), ("frames", q => q.Frames), ("cell_dx", q => q.Cell), ("triangles", q => q.Triangles), ("vertices", q => q.Vertices),
            ("open_edges", q => q.OpenEdges), ("non_manifold_edges", q => q.NonManifoldEdges), ("flipped_edges", q => q.FlippedEdges),
            ("zero_area", q => q.ZeroArea), ("late_blocks", q => q.LateBlocks), ("euler", q => q.Euler), ("components", q => q.Components), ("volume_ratio", q => q.Volume),
            ("flatness_dx", q => q.Flatness), ("slope_deg", q => q.Slope), ("level_error_dx", q => q.LevelError), ("ripple_dx", q => q.Ripple),
            ("covered", q => q.Covered), ("drops", q => q.Drops), ("drops_visible", q => q.DropsVisible), ("drop_radius_dx", q => q.DropRadius),
            ("merge_gap_dx", q => q.MergeGap), ("least_angle_deg", q => q.LeastAngle), ("one_percent_angle_deg", q => q.OnePercentAngle),
            ("mean_angle_deg", q => q.MeanAngle), ("shading_error_deg", q => q.ShadingError), ("face_error_deg", q => q.FaceError),
            ("flicker_dx", q => q.Flicker), ("gpu_ms", q => q.GpuMilliseconds),
        };

        public static IEnumerable<string> Columns => new[] { "state", "variant" }.Concat(columns.Select(c => c.Name)).Concat(new[] { "device", "date" });

        readonly List<string> lines = new List<string>
        {
            CsvText.Join(Columns),
        };

        readonly string folder, device, date;

        /// <summary>A table.</summary>
        /// <param name="folder">Folder of the file.</param>
        /// <param name="device">The graphics device.</param>
        public SurfaceQualityTable(string folder, string device)
        {
            this.folder = folder;
            this.device = device;
            date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
        }

        /// <summary>Adds a line and writes the file.</summary>
        public void Add(string state, string variant, SurfaceQuality quality)
        {
            lines.Add(CsvText.Join(new[] { state, variant }.Concat(columns.Select(c => CsvText.Text(c.Value(quality)))).Concat(new[] { device, date })));
            CsvText.WriteWhole(Path.Combine(folder, FileName), lines);
        }

        /// <summary>The figures that there are, in words.</summary>
        public static string Line(string state, string variant, SurfaceQuality q)
        {
            var text = new List<string> { Say("{0:F0} triangles", q.Triangles) };
            int defects = q.OpenEdges + q.NonManifoldEdges + q.FlippedEdges;
            text.Add(defects == 0 ? "closed" : Say("{0:F0} edges are wrong", defects));
            text.Add(Say("volume {0:F3}", q.Volume));
            text.Add(Say("flat to {0:F3} dx", q.Flatness));
            text.Add(Say("slope {0:F1}°", q.Slope));
            text.Add(Say("level {0:+0.000;-0.000} dx", q.LevelError));
            text.Add(Say("covered {0:P1}", double.IsNaN(q.Flatness) ? q.Covered : double.NaN));
            text.Add(q.Drops > 0 ? $"{q.DropsVisible} of {q.Drops} drops" : "");
            text.Add(Say("normals {0:F1}°", q.ShadingError));
            text.Add(Say("joined at {0:F1} dx", q.MergeGap));
            text.Add(Say("flicker {0:F4} dx", q.Flicker));
            text.Add(Say("{0:F1} ms", q.GpuMilliseconds));
            return $"{state}, {variant}: {string.Join(", ", text.Where(t => t.Length > 0))}.";
        }

        static string Say(string format, double value) => double.IsNaN(value) ? "" : string.Format(CultureInfo.InvariantCulture, format, value);
    }
}
