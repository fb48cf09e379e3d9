using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The globals of contact with triangles: Shaders/Solver/Cells/TriangleSweep.hlsl, and of both passes over a step.</summary>
    internal static class MeshContact
    {
        private static readonly int ContactDistance = Shader.PropertyToID("_ContactDistance");
        private static readonly int SweepDistance = Shader.PropertyToID("_SweepDistance");
        private static readonly int ContactFloor = Shader.PropertyToID("_ContactFloor");
        private static readonly int ContactTolerance = Shader.PropertyToID("_ContactTolerance");

        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings)
        {
            float rest = ContactDistances.Rest(settings), ulp = Ulp(0.5f * settings.DomainSize.magnitude);
            kernel.SetFloat(cmd, ContactDistance, rest);
            kernel.SetFloat(cmd, SweepDistance, 0.9f * rest);
            kernel.SetFloat(cmd, ContactFloor, Math.Max(10f * ulp, 0.01f * rest));
            kernel.SetFloat(cmd, ContactTolerance, Math.Max(1e-3f * rest, 4f * ulp));
        }

        /// <summary>What both passes over a step's contacts need.</summary>
        public static void SetStep(CommandBuffer cmd, ComputeKernel kernel, CellState state, in FluidStep step)
        {
            CellBindings.SetSearch(cmd, kernel, state);
            DomainBindings.SetFaces(cmd, kernel, state.Settings, ContactDistances.Rest(state.Settings));
            Set(cmd, kernel, state.Settings);
            state.Bodies.Bind(cmd, kernel, state.BodyStep.x, state.BodyStep.y);
            CellBindings.SetCounting(cmd, kernel, state, step);
            kernel.Set(cmd, state.Published.Counters);
        }

        // Spacing of floats at a number: 9.5e-7 at 15.
        private static float Ulp(float value) => (float)Math.Pow(2.0, Math.Floor(Math.Log(value, 2.0)) - 23.0);
    }
}
