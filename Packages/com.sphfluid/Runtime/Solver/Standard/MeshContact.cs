using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Distances of contact with triangles and the globals of Shaders/Solver/Standard/TriangleSweep.hlsl.</summary>
    internal static class MeshContact
    {
        // Over dx, where particles come to rest on triangles.
        const float Rest = 0.1f;

        // Over dx: ways that contact follows in a step; longer ones are shortened and counted.
        const float Longest = 8f;

        /// <summary>Where particles come to rest [m].</summary>
        public static float Distance(in FluidSolverSettings settings) => Rest * settings.Spacing;

        /// <summary>Longest way of a step [m].</summary>
        public static float LongestDisplacement(in FluidSolverSettings settings) => Longest * settings.Spacing;

        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            float rest = Distance(settings), ulp = Ulp(0.5f * settings.DomainSize.magnitude);
            kernel.SetFloat(cmd, StandardShaderIds.ContactDistance, rest);
            kernel.SetFloat(cmd, StandardShaderIds.SweepDistance, 0.9f * rest);
            kernel.SetFloat(cmd, StandardShaderIds.ContactFloor, System.Math.Max(10f * ulp, 0.01f * rest));
            kernel.SetFloat(cmd, StandardShaderIds.ContactTolerance, System.Math.Max(1e-3f * rest, 4f * ulp));
        }

        // Spacing of floats at a number: 9.5e-7 at 15.
        static float Ulp(float value) => (float)System.Math.Pow(2.0, System.Math.Floor(System.Math.Log(value, 2.0)) - 23.0);
    }
}
