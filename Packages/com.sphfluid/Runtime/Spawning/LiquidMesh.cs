using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The inside of a closed mesh as liquid, whether its faces look in or out.</summary>
    internal sealed class LiquidMesh : LiquidShape
    {
        private readonly MeshObstacle inside;

        /// <summary>The inside of triangles.</summary>
        /// <param name="name">Name for messages.</param>
        /// <param name="mesh">Closed mesh in simulation space [m].</param>
        /// <param name="velocity">Initial velocity in simulation space [m/s].</param>
        public LiquidMesh(string name, TriangleMesh mesh, Vector3 velocity) : base(name, FrameOf(mesh.Bounds), velocity)
        {
            double signed = SignedVolume(mesh);
            Volume = Math.Abs(signed);
            inside = new MeshObstacle(signed < 0.0 ? Turned(mesh) : mesh);
        }

        /// <inheritdoc/>
        public override double Volume { get; }

        /// <inheritdoc/>
        public override bool Contains(Vector3 point) => inside.Contains(point);

        // Σ A·(B × C)/6 by the divergence theorem, positive where faces look outward.
        internal static double SignedVolume(TriangleMesh mesh)
        {
            Vector3 centre = mesh.Bounds.center;
            double volume = 0.0;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                volume += Vector3.Dot(a - centre, Vector3.Cross(b - centre, c - centre)) / 6.0;
            }
            return volume;
        }

        private static TriangleMesh Turned(TriangleMesh mesh)
        {
            var indices = (int[])mesh.Indices.Clone();
            Array.Reverse(indices);
            return new TriangleMesh(mesh.Vertices, indices, mesh.IsClosed);
        }
    }
}
