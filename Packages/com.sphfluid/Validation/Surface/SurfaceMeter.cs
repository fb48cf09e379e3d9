using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Takes in the meshes that a variant makes of a state's frames, one after the other, and sums up.</summary>
    sealed class SurfaceMeter
    {
        // Distance of columns, largest step in time that counts as flicker, and how near a drop's surface comes to its particle, dx.
        const float ColumnSpacing = 0.5f, LargestStep = 1f, DropReach = 1f;

        readonly SurfaceState state;
        readonly SurfaceQuality sum;
        readonly MeshColumns columns;
        readonly List<double[]> heights = new List<double[]>();
        readonly List<ColumnStatistics> tops = new List<ColumnStatistics>();
        readonly List<TriangleShapes> shapes = new List<TriangleShapes>();
        readonly List<NormalError> normals = new List<NormalError>();
        readonly List<double> levels = new List<double>(), volumes = new List<double>(), dropRadii = new List<double>();

        /// <summary>A meter for a state.</summary>
        /// <param name="state">The state.</param>
        /// <param name="cell">Edge of a cell [dx].</param>
        public SurfaceMeter(SurfaceState state, double cell)
        {
            this.state = state;
            sum = new SurfaceQuality { Particles = state.Frames[0].Length, Cell = cell };
            if (state.Top.HasValue)
                columns = new MeshColumns(state.Top.Value, ColumnSpacing * state.Spacing);
        }

        /// <summary>Takes in the mesh of the next frame.</summary>
        public void Add(SurfaceMesh mesh)
        {
            MeshEdges edges = MeshEdges.Of(mesh);
            sum.Triangles += edges.Triangles;
            sum.Vertices += edges.Vertices;
            sum.Euler += edges.Euler;
            sum.OpenEdges += edges.OpenEdges;
            sum.NonManifoldEdges += edges.NonManifoldEdges;
            sum.FlippedEdges += edges.FlippedEdges;
            volumes.Add(mesh.Volume() / state.Volume);
            shapes.Add(TriangleShapes.Of(mesh, (float)sum.Cell * state.Spacing));
            sum.ZeroArea += shapes[shapes.Count - 1].ZeroArea;
            if (state.Normal != null)
                normals.Add(NormalError.Of(mesh, state.Normal));
            if (columns != null)
                AddTop(mesh);
            AddParts(new MeshComponents(mesh));
            sum.Frames++;
        }

        /// <summary>The means.</summary>
        public SurfaceQuality Result()
        {
            foreach (Action<double> divide in new Action<double>[] { n => sum.Triangles /= n, n => sum.Vertices /= n, n => sum.Euler /= n, n => sum.Components /= n })
                divide(sum.Frames);
            sum.Volume = Mean(volumes);
            (sum.LeastAngle, sum.OnePercentAngle, sum.MeanAngle) = (shapes.Min(s => s.LeastAngle), Mean(shapes.Select(s => s.OnePercentAngle)), Mean(shapes.Select(s => s.MeanAngle)));
            (sum.ShadingError, sum.FaceError) = (Mean(normals.Select(n => n.Shading)), Mean(normals.Select(n => n.Faces)));
            sum.DropRadius = Mean(dropRadii);
            sum.Covered = Mean(tops.Select(t => t.Covered));
            if (state.Level != null)
            {
                sum.Flatness = Mean(tops.Select(t => t.Rms)) / state.Spacing;
                sum.Slope = Mean(tops.Select(t => t.Slope));
                sum.LevelError = Mean(levels);
                sum.Ripple = levels.Count > 1 ? Math.Sqrt(Mean(levels.Select(l => (l - sum.LevelError) * (l - sum.LevelError)))) : double.NaN;
            }
            if (state.InTime)
                sum.Flicker = ColumnStatistics.Flicker(heights, LargestStep * state.Spacing) / state.Spacing;
            return sum;
        }

        void AddTop(SurfaceMesh mesh)
        {
            heights.Add(columns.Heights(mesh));
            ColumnStatistics top = ColumnStatistics.Of(heights[sum.Frames], columns.Across, ColumnSpacing * state.Spacing);
            tops.Add(top);
            if (state.Level != null)
                levels.Add((top.Mean - state.Level(sum.Frames)) / state.Spacing);
        }

        void AddParts(MeshComponents parts)
        {
            sum.Components += parts.Count;
            if (state.Gaps != null && parts.Count == 1 && !(sum.MergeGap >= state.Gaps[sum.Frames]))
                sum.MergeGap = state.Gaps[sum.Frames];
            foreach (Vector3 drop in state.Drops)
            {
                int part = parts.Near(drop, DropReach * state.Spacing);
                sum.Drops++;
                sum.DropsVisible += part >= 0 ? 1 : 0;
                if (part >= 0 && state.Drops.Length == sum.Particles)
                    dropRadii.Add(Math.Pow(Math.Abs(parts.Volume(part)) * 3.0 / (4.0 * Math.PI), 1.0 / 3.0) / state.Spacing);
            }
        }

        static double Mean(IEnumerable<double> numbers) => numbers.DefaultIfEmpty(double.NaN).Average();
    }
}
