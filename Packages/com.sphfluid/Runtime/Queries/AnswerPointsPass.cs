using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Answers what the liquid is at points in the world.</summary>
    internal sealed class AnswerPointsPass : ComputePass
    {
        static readonly int Queries = Id("_PointQueries");
        static readonly int Results = Id("_PointResults");
        static readonly int Pressure = Id("_Pressure");
        static readonly int PointCount = Id("_PointCount");
        static readonly int InverseSupport = Id("_InverseSupport");
        static readonly int KernelFactor = Id("_KernelFactor");
        static readonly int RestDensity = Id("_RestDensity");
        static readonly int DomainHalfSize = Id("_DomainHalfSize");
        static readonly int PoseOrigin = Id("_PoseOrigin");
        static readonly int PoseX = Id("_PoseX");
        static readonly int PoseY = Id("_PoseY");
        static readonly int PoseZ = Id("_PoseZ");

        readonly ComputeKernel kernel;

        public AnswerPointsPass(FluidShaderSet shaders)
            : base(shaders, "AnswerPoints")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="position">World position of simulation space's origin [m].</param>
        /// <param name="rotation">World rotation of simulation space.</param>
        /// <param name="queries">World position [m] and generation of each point, 16 bytes.</param>
        /// <param name="results">Receives <see cref="FluidPointResult"/> of each.</param>
        /// <param name="count">Number of points.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, Vector3 position, Quaternion rotation, GraphicsBuffer queries, GraphicsBuffer results, int count)
        {
            FluidSolverSettings settings = solver.Settings;
            double radius = settings.SupportRadius;
            using (Sample(cmd))
            {
                solver.BindNeighbours(cmd, kernel);
                DomainBindings.SetFaces(cmd, kernel, settings);
                kernel.SetBuffer(cmd, Pressure, solver.Pressure);
                kernel.SetBuffer(cmd, Queries, queries);
                kernel.SetBuffer(cmd, Results, results);
                kernel.SetInt(cmd, PointCount, count);
                kernel.SetFloat(cmd, InverseSupport, 1f / settings.SupportRadius);
                kernel.SetFloat(cmd, KernelFactor, (float)(settings.ParticleMass * 21.0 / (2.0 * Math.PI * radius * radius * radius)));
                kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
                kernel.SetVector(cmd, DomainHalfSize, 0.5f * settings.DomainSize);
                kernel.SetVector(cmd, PoseOrigin, position);
                kernel.SetVector(cmd, PoseX, rotation * Vector3.right);
                kernel.SetVector(cmd, PoseY, rotation * Vector3.up);
                kernel.SetVector(cmd, PoseZ, rotation * Vector3.forward);
                kernel.DispatchThreads(cmd, count);
            }
        }
    }
}
