using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// A line of surface-quality.csv: what a surface variant made of a state. Means over the frames unless it says sum; not a number where
    /// the state has no reference for it.
    /// </summary>
    internal sealed class SurfaceQuality : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<SurfaceQuality> Format = new TableFormat<SurfaceQuality>("surface-quality.csv")
            .Text("state", q => q.State)
            .Text("variant", q => q.Variant)
            .Number("particles", q => q.Particles)
            .Number("frames", q => q.Frames)
            .Number("cell_dx", q => q.Cell)
            .Number("triangles", q => q.Triangles)
            .Number("vertices", q => q.Vertices)
            .Number("open_edges", q => q.OpenEdges)
            .Number("non_manifold_edges", q => q.NonManifoldEdges)
            .Number("flipped_edges", q => q.FlippedEdges)
            .Number("zero_area", q => q.ZeroArea)
            .Number("late_blocks", q => q.LateBlocks)
            .Number("euler", q => q.Euler)
            .Number("components", q => q.Components)
            .Number("volume_ratio", q => q.Volume)
            .Number("flatness_dx", q => q.Flatness)
            .Number("slope_deg", q => q.Slope)
            .Number("level_error_dx", q => q.LevelError)
            .Number("ripple_dx", q => q.Ripple)
            .Number("covered", q => q.Covered)
            .Number("drops", q => q.Drops)
            .Number("drops_visible", q => q.DropsVisible)
            .Number("drop_radius_dx", q => q.DropRadius)
            .Number("merge_gap_dx", q => q.MergeGap)
            .Number("least_angle_deg", q => q.LeastAngle)
            .Number("one_percent_angle_deg", q => q.OnePercentAngle)
            .Number("mean_angle_deg", q => q.MeanAngle)
            .Number("shading_error_deg", q => q.ShadingError)
            .Number("face_error_deg", q => q.FaceError)
            .Number("flicker_dx", q => q.Flicker)
            .Number("gpu_ms", q => q.GpuMilliseconds)
            .Text("device", q => q.Device)
            .Text("date", q => q.Date);

        /// <summary>Name of the state.</summary>
        public string State;

        /// <summary>Name of the variant.</summary>
        public string Variant;

        /// <summary>Particles of a frame.</summary>
        public int Particles;

        /// <summary>Number of frames.</summary>
        public int Frames;

        /// <summary>Edge of a cell [dx].</summary>
        public double Cell;

        /// <summary>Triangles and vertices of a frame.</summary>
        public double Triangles, Vertices;

        /// <summary>Defects, summed over the frames: see <see cref="MeshEdges"/> and <see cref="TriangleShapes"/>.</summary>
        public int OpenEdges, NonManifoldEdges, FlippedEdges, ZeroArea;

        /// <summary>See <see cref="SurfaceVariant.TakeLateBlocks"/>, summed over the frames.</summary>
        public int LateBlocks;

        /// <summary>Euler characteristic and parts of a frame.</summary>
        public double Euler, Components;

        /// <summary>Volume of the mesh over that of the liquid.</summary>
        public double Volume = double.NaN;

        /// <summary>Deviation of the top from a plane, root mean square [dx]; its slope [degrees].</summary>
        public double Flatness = double.NaN, Slope = double.NaN;

        /// <summary>
        /// Height of the top over the liquid's level [dx], and how much it changes between frames, root mean square [dx].
        /// </summary>
        public double LevelError = double.NaN, Ripple = double.NaN;

        /// <summary>Share of the columns over the liquid that intersect the mesh.</summary>
        public double Covered = double.NaN;

        /// <summary>Lone particles, and those of them that can be seen; of the frames together.</summary>
        public int Drops, DropsVisible;

        /// <summary>Radius of a ball as large as a visible drop, where there is nothing but drops [dx]: 0.62 is a spacing cubed.</summary>
        public double DropRadius = double.NaN;

        /// <summary>Widest gap at which two bodies are drawn as one [dx].</summary>
        public double MergeGap = double.NaN;

        /// <summary>Smallest angles of the triangles [degrees]: of all, of the worst hundredth, mean.</summary>
        public double LeastAngle = double.NaN, OnePercentAngle = double.NaN, MeanAngle = double.NaN;

        /// <summary>Error of the normals at vertices, and of the triangles [degrees].</summary>
        public double ShadingError = double.NaN, FaceError = double.NaN;

        /// <summary>See <see cref="ColumnStatistics.Flicker"/> [dx].</summary>
        public double Flicker = double.NaN;

        /// <summary>GPU time of the surface's passes in a frame [ms], the sort of the particles not counted.</summary>
        public double GpuMilliseconds = double.NaN;

        /// <summary>The figures that there are, in words.</summary>
        public override string ToString()
        {
            var text = new List<string> { Say("{0:F0} triangles", Triangles) };
            int defects = OpenEdges + NonManifoldEdges + FlippedEdges;
            text.Add(defects == 0 ? "closed" : Say("{0:F0} edges are wrong", defects));
            text.Add(Say("volume {0:F3}", Volume));
            text.Add(Say("flat to {0:F3} dx", Flatness));
            text.Add(Say("slope {0:F1}°", Slope));
            text.Add(Say("level {0:+0.000;-0.000} dx", LevelError));
            text.Add(Say("covered {0:P1}", double.IsNaN(Flatness) ? Covered : double.NaN));
            text.Add(Drops > 0 ? $"{DropsVisible} of {Drops} drops" : "");
            text.Add(Say("normals {0:F1}°", ShadingError));
            text.Add(Say("joined at {0:F1} dx", MergeGap));
            text.Add(Say("flicker {0:F4} dx", Flicker));
            text.Add(Say("{0:F1} ms", GpuMilliseconds));
            return $"{State}, {Variant}: {string.Join(", ", text.Where(t => t.Length > 0))}.";
        }

        private static string Say(string format, double value) => double.IsNaN(value) ? ""
            : string.Format(CultureInfo.InvariantCulture, format, value);
    }
}
