using System.Linq;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Meshes for the CPU solver's tests, corners rounded to float as both solvers hold them.</summary>
    internal static class CpuScenes
    {
        public static ReferenceMesh[] Meshes(bool closed)
        {
            ReferenceMesh box = MeshShapes.Box(new Double3(0.013, -0.02, 0.01), new Double3(0.071, 0.052, 0.063), 3);
            box.Closed = closed;
            return new[] { Rounded(box), Sheet() };
        }

        public static ReferenceMesh Sheet()
        {
            return Rounded(MeshShapes.Triangle(new Double3(-0.15, 0.1, -0.1), new Double3(0.12, 0.13, -0.08),
                new Double3(0.02, 0.09, 0.14)));
        }

        public static void AddMeshes(CpuFluidSolver solver, params ReferenceMesh[] meshes)
        {
            foreach (ReferenceMesh mesh in meshes) solver.AddMesh(mesh.Triangles.SelectMany(t => t.Select(Float)).ToArray(), mesh.Closed);
        }

        public static Vector3 Float(Double3 v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        private static ReferenceMesh Rounded(ReferenceMesh mesh)
        {
            mesh.Triangles = mesh.Triangles.Select(t => t.Select(c => (Double3)Float(c)).ToArray()).ToList();
            return mesh;
        }
    }
}
