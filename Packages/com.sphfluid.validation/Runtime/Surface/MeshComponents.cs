using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The connected parts of a mesh.</summary>
    public sealed class MeshComponents
    {
        private readonly SurfaceMesh mesh;
        private readonly int[] componentOf;
        private readonly double[] volumes;

        /// <summary>Finds the parts: vertices that a triangle joins belong together.</summary>
        /// <param name="mesh">Any mesh.</param>
        public MeshComponents(SurfaceMesh mesh)
        {
            this.mesh = mesh;
            int[] parents = Join(mesh);
            componentOf = new int[mesh.VertexCount];
            var numbers = new Dictionary<int, int>();
            foreach (int vertex in mesh.Indices)
            {
                int root = Root(parents, vertex);
                if (!numbers.TryGetValue(root, out int number)) numbers.Add(root, number = numbers.Count);
                componentOf[vertex] = number;
            }
            volumes = new double[numbers.Count];
            for (int i = 0; i < mesh.Indices.Length; i += 3)
            {
                volumes[componentOf[mesh.Indices[i]]] += Vector3.Dot(Corner(i), Vector3.Cross(Corner(i + 1), Corner(i + 2))) / 6.0;
            }
        }

        /// <summary>Number of parts.</summary>
        public int Count => volumes.Length;

        /// <summary>Volume that a part encloses [m³]; negative for a bubble in the liquid.</summary>
        /// <param name="component">0 to <see cref="Count"/> − 1.</param>
        public double Volume(int component) => volumes[component];

        /// <summary>The part with the vertex nearest to a point, or −1 where none is within reach.</summary>
        /// <param name="point">The point [m].</param>
        /// <param name="reach">Largest distance [m].</param>
        public int Near(Vector3 point, float reach)
        {
            int nearest = -1;
            float least = reach * reach;
            foreach (int vertex in mesh.Indices)
            {
                float distance = (mesh.Positions[vertex] - point).sqrMagnitude;
                if (distance > least) continue;
                least = distance;
                nearest = componentOf[vertex];
            }
            return nearest;
        }

        private Vector3 Corner(int i) => mesh.Positions[mesh.Indices[i]];

        private static int[] Join(SurfaceMesh mesh)
        {
            var parents = new int[mesh.VertexCount];
            for (int i = 0; i < parents.Length; i++) parents[i] = i;
            for (int i = 0; i < mesh.Indices.Length; i++)
            {
                int next = mesh.Indices[i % 3 == 2 ? i - 2 : i + 1];
                parents[Root(parents, mesh.Indices[i])] = Root(parents, next);
            }
            return parents;
        }

        private static int Root(int[] parents, int vertex)
        {
            while (parents[vertex] != vertex) vertex = parents[vertex] = parents[parents[vertex]];
            return vertex;
        }
    }
}
