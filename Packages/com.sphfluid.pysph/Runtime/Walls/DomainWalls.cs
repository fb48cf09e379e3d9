using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The faces of a domain that are walls, as layers of particles behind them: the first half a spacing behind the face, as the liquid's
    /// outermost are half a spacing before it. Along the faces they lie a spacing apart, stretched so that a whole number fits.
    /// </summary>
    internal static class DomainWalls
    {
        /// <summary>The particles of the walls.</summary>
        /// <param name="size">Edge lengths of the domain [m].</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        /// <param name="layers">Layers of a wall.</param>
        /// <param name="faces">Which faces are walls, and their velocities.</param>
        public static List<WallParticle> Of(Vector3 size, float spacing, int layers, in FluidBoundaries faces)
        {
            var walls = new List<WallParticle>();
            (int low, int count, int high) x = Range(0, size, spacing, layers, faces), y = Range(1, size, spacing, layers, faces),
                z = Range(2, size, spacing, layers, faces);
            for (int k = -z.low; k < z.count + z.high; k++)
                for (int j = -y.low; j < y.count + y.high; j++)
                    for (int i = -x.low; i < x.count + x.high; i++)
                    {
                        if (IsInside(i, x.count) && IsInside(j, y.count) && IsInside(k, z.count))
                        {
                            i = x.count - 1;
                            continue;
                        }
                        walls.Add(new WallParticle
                        {
                            Position = new Vector3(Coordinate(i, x.count, size.x, spacing), Coordinate(j, y.count, size.y, spacing),
                                Coordinate(k, z.count, size.z, spacing)),
                            Velocity = VelocityAt(new Vector3Int(i, j, k), new Vector3Int(x.count, y.count, z.count), faces),
                        });
                    }
            return walls;
        }

        /// <summary>Whether a face is a wall.</summary>
        public static bool IsWall(in FluidBoundaries faces, FluidFaces face) =>
            ((faces.Open | FluidBoundaries.FacesOf(faces.Periodic)) & face) == 0;

        // Layers below, sites within and layers above the domain along an axis.
        private static (int low, int count, int high) Range(int axis, Vector3 size, float spacing, int layers, in FluidBoundaries faces)
        {
            var low = (FluidFaces)(1 << 2 * axis);
            var high = (FluidFaces)(2 << 2 * axis);
            int count = Math.Max(1, (int)Math.Round(size[axis] / (double)spacing));
            return (IsWall(faces, low) ? layers : 0, count, IsWall(faces, high) ? layers : 0);
        }

        private static bool IsInside(int index, int count) => index >= 0 && index < count;

        private static float Coordinate(int index, int count, float size, float spacing)
        {
            double half = 0.5 * size;
            if (index < 0) return (float)(-half + (index + 0.5) * spacing);
            if (index >= count) return (float)(half + (index - count + 0.5) * spacing);
            return (float)(-half + (index + 0.5) * size / count);
        }

        // At an edge of two walls the axis that comes first decides.
        private static Vector3 VelocityAt(Vector3Int site, Vector3Int count, in FluidBoundaries faces) =>
            site.x < 0 ? faces.LowX : site.x >= count.x ? faces.HighX :
            site.y < 0 ? faces.LowY : site.y >= count.y ? faces.HighY :
            site.z < 0 ? faces.LowZ : faces.HighZ;
    }
}
