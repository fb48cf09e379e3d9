using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Where and into what a liquid's questions of a frame are answered.</summary>
    internal struct QueryTarget
    {
        public FluidSolver Solver;

        /// <summary>World position of simulation space's origin [m].</summary>
        public Vector3 Position;

        /// <summary>World rotation of simulation space.</summary>
        public Quaternion Rotation;

        /// <summary>Receives the answers of all kinds, 32 bytes each.</summary>
        public GraphicsBuffer Results;
    }

    /// <summary>Records the globals of Shaders/Queries/QuerySpace.hlsl and QueryDensity.hlsl.</summary>
    internal static class QueryBindings
    {
        private static readonly int Queries = Shader.PropertyToID("_Queries");
        private static readonly int Results = Shader.PropertyToID("_Results");
        private static readonly int QueryCount = Shader.PropertyToID("_QueryCount");
        private static readonly int FirstResult = Shader.PropertyToID("_FirstResult");
        private static readonly int DomainHalfSize = Shader.PropertyToID("_DomainHalfSize");
        private static readonly int PoseOrigin = Shader.PropertyToID("_PoseOrigin");
        private static readonly int PoseX = Shader.PropertyToID("_PoseX");
        private static readonly int PoseY = Shader.PropertyToID("_PoseY");
        private static readonly int PoseZ = Shader.PropertyToID("_PoseZ");
        private static readonly int InverseSupport = Shader.PropertyToID("_InverseSupport");
        private static readonly int KernelFactor = Shader.PropertyToID("_KernelFactor");
        private static readonly int RestDensity = Shader.PropertyToID("_RestDensity");

        /// <summary>The queries of a kind, the space that they are in, and where their answers go.</summary>
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in QueryTarget target, GraphicsBuffer queries, int count, int first)
        {
            SetSpace(cmd, kernel, target);
            SetQueries(cmd, kernel, queries, count);
            SetResults(cmd, kernel, target, first);
        }

        /// <summary>The queries of a kind.</summary>
        public static void SetQueries(CommandBuffer cmd, ComputeKernel kernel, GraphicsBuffer queries, int count)
        {
            kernel.SetBuffer(cmd, Queries, queries);
            kernel.SetInt(cmd, QueryCount, count);
        }

        /// <summary>Where the answers of a kind go.</summary>
        public static void SetResults(CommandBuffer cmd, ComputeKernel kernel, in QueryTarget target, int first)
        {
            kernel.SetBuffer(cmd, Results, target.Results);
            kernel.SetInt(cmd, FirstResult, first);
        }

        /// <summary>Simulation space in the world.</summary>
        public static void SetSpace(CommandBuffer cmd, ComputeKernel kernel, in QueryTarget target)
        {
            target.Solver.BindNeighbours(cmd, kernel);
            kernel.SetVector(cmd, DomainHalfSize, 0.5f * target.Solver.Settings.DomainSize);
            kernel.SetVector(cmd, PoseOrigin, target.Position);
            kernel.SetVector(cmd, PoseX, target.Rotation * Vector3.right);
            kernel.SetVector(cmd, PoseY, target.Rotation * Vector3.up);
            kernel.SetVector(cmd, PoseZ, target.Rotation * Vector3.forward);
        }

        /// <summary>The density at a place.</summary>
        public static void SetDensity(CommandBuffer cmd, ComputeKernel kernel, in QueryTarget target)
        {
            FluidSolverSettings settings = target.Solver.Settings;
            double radius = settings.SupportRadius;
            DomainBindings.SetFaces(cmd, kernel, settings);
            kernel.SetFloat(cmd, InverseSupport, 1f / settings.SupportRadius);
            kernel.SetFloat(cmd, KernelFactor, (float)(settings.ParticleMass * 21.0 / (2.0 * System.Math.PI * radius * radius * radius)));
            kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
        }
    }
}
