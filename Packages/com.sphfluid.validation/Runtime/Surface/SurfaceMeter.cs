using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Takes in the meshes that a variant makes of a state's frames, one after the other, and sums up.</summary>
    internal sealed class SurfaceMeter
    {
        // Distance of columns, largest step in time that counts as flicker, and how near a drop's surface comes to its particle, dx.
        private const float ColumnSpacing = 0.5f, LargestStep = 1f, DropReach = 1f;

        private readonly SurfaceState state;
        private readonly SurfaceQuality sum;
        private readonly MeshColumns columns;
        private readonly List<double[]> heights = new List<double[]>();
        private readonly List<ColumnStatistics> tops = new List<ColumnStatistics>();
        private readonly List<MeshEdges> edges = new List<MeshEdges>();
        private readonly List<TriangleShapes> shapes = new List<TriangleShapes>();
        private readonly List<NormalError> normals = new List<NormalError>();
        private readonly List<double> levels = new List<double>(), volumes = new List<double>(), components = new List<double>(),
            dropRadii = new List<double>();

        /// <summary>A meter for a state.</summary>
        /// <param name="state">The state.</param>
        /// <param name="cell">Edge of a cell [dx].</param>
        public SurfaceMeter(SurfaceState state, double cell)
        {
            this.state = state;
            sum = new SurfaceQuality { Particles = state.Frames[0].Length, Cell = cell };
            if (state.Top.HasValue) columns = new MeshColumns(state.Top.Value, ColumnSpacing * state.Spacing);
        }

        /// <summary>Takes in the mesh of the next frame.</summary>
        public void Add(SurfaceMesh mesh)
        {
            edges.Add(MeshEdges.Of(mesh));
            shapes.Add(TriangleShapes.Of(mesh, (float)sum.Cell * state.Spacing));
            volumes.Add(mesh.Volume() / state.Volume);
            if (state.Normal != null) normals.Add(NormalError.Of(mesh, state.Normal));
            if (columns != null) AddTop(mesh);
            AddParts(new MeshComponents(mesh));
            sum.Frames++;
        }

        /// <summary>The means.</summary>
        public SurfaceQuality Result()
        {
            sum.Triangles = Mean(edges.Select(e => (double)e.Triangles));
            sum.Vertices = Mean(edges.Select(e => (double)e.Vertices));
            sum.Euler = Mean(edges.Select(e => (double)e.Euler));
            sum.OpenEdges = edges.Sum(e => e.OpenEdges);
            sum.NonManifoldEdges = edges.Sum(e => e.NonManifoldEdges);
            sum.FlippedEdges = edges.Sum(e => e.FlippedEdges);
            sum.ZeroArea = shapes.Sum(s => s.ZeroArea);
            sum.LeastAngle = shapes.Min(s => s.LeastAngle);
            sum.OnePercentAngle = Mean(shapes.Select(s => s.OnePercentAngle));
            sum.MeanAngle = Mean(shapes.Select(s => s.MeanAngle));
            sum.Volume = Mean(volumes);
            sum.Components = Mean(components);
            sum.ShadingError = Mean(normals.Select(n => n.Shading));
            sum.FaceError = Mean(normals.Select(n => n.Faces));
            sum.DropRadius = Mean(dropRadii);
            sum.Covered = Mean(tops.Select(t => t.Covered));
            if (state.Level != null)
            {
                sum.Flatness = Mean(tops.Select(t => t.Rms)) / state.Spacing;
                sum.Slope = Mean(tops.Select(t => t.Slope));
                sum.LevelError = Mean(levels);
                sum.Ripple = levels.Count > 1 ? Math.Sqrt(Mean(levels.Select(l => (l - sum.LevelError) * (l - sum.LevelError))))
                    : double.NaN;
            }
            if (state.InTime) sum.Flicker = ColumnStatistics.Flicker(heights, LargestStep * state.Spacing) / state.Spacing;
            return sum;
        }

        private void AddTop(SurfaceMesh mesh)
        {
            heights.Add(columns.Heights(mesh));
            ColumnStatistics top = ColumnStatistics.Of(heights[sum.Frames], columns.Across, ColumnSpacing * state.Spacing);
            tops.Add(top);
            if (state.Level != null) levels.Add((top.Mean - state.Level(sum.Frames)) / state.Spacing);
        }

        private void AddParts(MeshComponents parts)
        {
            components.Add(parts.Count);
            if (state.Gaps != null && parts.Count == 1 && !(sum.MergeGap >= state.Gaps[sum.Frames])) sum.MergeGap = state.Gaps[sum.Frames];
            foreach (Vector3 drop in state.Drops)
            {
                int part = parts.Near(drop, DropReach * state.Spacing);
                sum.Drops++;
                sum.DropsVisible += part >= 0 ? 1 : 0;
                if (part >= 0 && state.Drops.Length == sum.Particles)
                {
                    dropRadii.Add(Math.Pow(Math.Abs(parts.Volume(part)) * 3.0 / (4.0 * Math.PI), 1.0 / 3.0) / state.Spacing);
                }
            }
        }

        private static double Mean(IEnumerable<double> numbers) => numbers.DefaultIfEmpty(double.NaN).Average();
    }
}
