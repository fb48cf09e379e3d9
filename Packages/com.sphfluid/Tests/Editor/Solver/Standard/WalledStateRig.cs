using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The state of a liquid whose walls at meshes the test writes itself.</summary>
    internal static class WalledStateRig
    {
        /// <summary>A state with a small box as body, so that there are walls; no particle has any yet.</summary>
        public static StandardStateRig Create(in FluidSolverSettings settings, int count, out CollisionBodies bodies) =>
            Create(settings, TestMeshes.Cube(), 0.1f, count, out bodies);

        /// <summary>A state with triangles as body, three corners each.</summary>
        public static StandardStateRig Create(in FluidSolverSettings settings, Vector3[] corners, int count, out CollisionBodies bodies)
        {
            var mesh = new Mesh { name = "Test Triangles", vertices = corners, triangles = Enumerable.Range(0, corners.Length).ToArray() };
            return Create(settings, mesh, 1f, count, out bodies);
        }

        private static StandardStateRig Create(in FluidSolverSettings settings, Mesh mesh, float scale, int count,
            out CollisionBodies bodies)
        {
            var rig = new StandardStateRig(settings, count);
            bodies = new CollisionBodies(settings);
            using (var colliders = new ColliderRig { DomainSize = settings.DomainSize, Spacing = settings.Spacing })
            {
                colliders.AddMesh(mesh).transform.localScale = scale * Vector3.one;
                colliders.Gather();
                bodies.Update(colliders.Scene.Solids);
            }

            rig.State.Bodies = bodies;
            rig.State.RequireWalls();
            Assert.That(rig.State.HasBodies, Is.True);
            return rig;
        }

        /// <summary>Gives particles, in the order of the sort, their walls.</summary>
        public static void SetWalls(StandardStateRig rig, List<StoredWall.Packed> walls, Func<int, bool> has = null)
        {
            rig.State.Walls.NearWalls.SetData(walls.ToArray());
            rig.State.List.WallSlot.SetData(walls.Select((_, i) => has == null || has(i) ? 1u + (uint)i : 0u).ToArray());
        }
    }
}
