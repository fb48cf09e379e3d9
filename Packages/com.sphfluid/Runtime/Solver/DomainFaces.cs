using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Where the domain's faces are walls and where they are open: the globals of Shaders/Solver/DomainFaces.hlsl.</summary>
    internal static class DomainFaces
    {
        // m: where a face is not of the kind. Its square is still a float.
        const float FarAway = 1e18f;

        static readonly int WallsLow = Shader.PropertyToID("_WallsLow");
        static readonly int WallsHigh = Shader.PropertyToID("_WallsHigh");
        static readonly int OpenLow = Shader.PropertyToID("_OpenLow");
        static readonly int OpenHigh = Shader.PropertyToID("_OpenHigh");

        /// <summary>Records both; the walls a distance of <paramref name="inset"/> [m] further in than the faces.</summary>
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in FluidSolverSettings settings, float inset = 0f)
        {
            FluidBoundaries boundaries = settings.Boundaries;
            FluidFaces walls = ~(boundaries.Open | FluidBoundaries.FacesOf(boundaries.Periodic));
            Vector3 face = 0.5f * settings.DomainSize, wall = face - inset * Vector3.one;
            kernel.SetVector(cmd, WallsLow, -Where(wall, walls, FluidFaces.LowX, FluidFaces.LowY, FluidFaces.LowZ));
            kernel.SetVector(cmd, WallsHigh, Where(wall, walls, FluidFaces.HighX, FluidFaces.HighY, FluidFaces.HighZ));
            kernel.SetVector(cmd, OpenLow, -Where(face, boundaries.Open, FluidFaces.LowX, FluidFaces.LowY, FluidFaces.LowZ));
            kernel.SetVector(cmd, OpenHigh, Where(face, boundaries.Open, FluidFaces.HighX, FluidFaces.HighY, FluidFaces.HighZ));
        }

        static Vector3 Where(Vector3 place, FluidFaces faces, FluidFaces x, FluidFaces y, FluidFaces z) => new Vector3(
            (faces & x) != 0 ? place.x : FarAway, (faces & y) != 0 ? place.y : FarAway, (faces & z) != 0 ? place.z : FarAway);
    }
}
