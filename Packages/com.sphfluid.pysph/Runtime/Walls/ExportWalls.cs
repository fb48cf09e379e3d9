using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Faces of the domain and colliders as particles.</summary>
    internal static class ExportWalls
    {
        /// <summary>The walls that stay: faces of the domain, then colliders where no wall is yet.</summary>
        /// <param name="start">The liquid and its constants.</param>
        /// <param name="still">Colliders that stay.</param>
        /// <param name="layers">Layers of a wall.</param>
        public static WallParticle[] Still(ExportStart start, IEnumerable<FluidObstacle> still, int layers)
        {
            ExportConstants constants = start.Constants;
            List<WallParticle> walls = DomainWalls.Of(constants.DomainSize, constants.Spacing, layers, constants.Boundaries);
            SpacedPoints taken = null, liquid = null;
            foreach (FluidObstacle solid in still)
            {
                taken ??= Points(walls.Count, i => walls[i].Position, constants.Spacing);
                if (!solid.Mesh.IsClosed) liquid ??= Points(start.Particles.Length, i => start.Particles[i].Position, constants.Spacing);
                foreach (Vector3 place in SurfaceSampler.Sample(solid.Mesh, constants.Spacing, layers, Reach(constants, layers),
                    taken, liquid))
                {
                    walls.Add(new WallParticle { Position = place });
                }
            }
            return walls.ToArray();
        }

        /// <summary>The particles of a collider that moves, from its pivot.</summary>
        /// <param name="start">The liquid and its constants.</param>
        /// <param name="solid">The collider at the start.</param>
        /// <param name="pivot">Its pivot then [m].</param>
        /// <param name="layers">Layers of a wall.</param>
        public static WallParticle[] Moving(ExportStart start, FluidObstacle solid, Vector3 pivot, int layers)
        {
            float spacing = start.Constants.Spacing;
            Bounds all = solid.Mesh.Bounds;
            all.Expand(2f * layers * spacing);
            SpacedPoints liquid = solid.Mesh.IsClosed ? null : Points(start.Particles.Length, i => start.Particles[i].Position, spacing);
            return SurfaceSampler.Sample(solid.Mesh, spacing, layers, all, new SpacedPoints(spacing), liquid)
                .ConvertAll(place => new WallParticle { Position = place - pivot }).ToArray();
        }

        // The domain; where a face is open, as far beyond it as walls are thick.
        private static Bounds Reach(in ExportConstants constants, int layers)
        {
            Vector3 min = -0.5f * constants.DomainSize, max = 0.5f * constants.DomainSize;
            for (int axis = 0; axis < 3; axis++)
            {
                if ((constants.Boundaries.Open & (FluidFaces)(1 << 2 * axis)) != 0) min[axis] -= layers * constants.Spacing;
                if ((constants.Boundaries.Open & (FluidFaces)(2 << 2 * axis)) != 0) max[axis] += layers * constants.Spacing;
            }
            var reach = new Bounds();
            reach.SetMinMax(min, max);
            return reach;
        }

        private static SpacedPoints Points(int count, Func<int, Vector3> place, float spacing)
        {
            var points = new SpacedPoints(spacing);
            for (int i = 0; i < count; i++) points.Add(place(i));
            return points;
        }
    }
}
