using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Sums a liquid's state, a record a group of threads.</summary>
    internal sealed class MeasureStatisticsPass : ComputePass
    {
        private static readonly int Statistics = Id("_Statistics");
        private static readonly int Density = Id("_Density");
        private static readonly int Pressure = Id("_Pressure");
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int FirstRange = Id("_FirstRange");
        private static readonly int CellCount = Id("_CellCount");
        private static readonly int GroupCount = Id("_GroupCount");
        private static readonly int RestDensity = Id("_RestDensity");
        private static readonly int Spacing = Id("_Spacing");
        private static readonly int HalfStep = Id("_HalfStep");
        private static readonly int Potential = Id("_Potential");
        private static readonly int PotentialCentre = Id("_PotentialCentre");
        private static readonly int PotentialRate = Id("_PotentialRate");
        private static readonly int DomainHalfSize = Id("_DomainHalfSize");

        private readonly ComputeKernel kernel;

        public MeasureStatisticsPass(FluidShaderSet shaders)
            : base(shaders, "MeasureStatistics")
        {
            kernel = Kernel();
        }

        /// <summary>Records for a number of particles.</summary>
        public int Groups(int particleCount) => (particleCount + kernel.GroupSize.x - 1) / kernel.GroupSize.x;

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="records">Receives <see cref="FluidStatisticsRecord.Size"/> float4 a group.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, GraphicsBuffer records)
        {
            FluidSolverSettings settings = solver.Settings;
            using (Sample(cmd))
            {
                solver.BindNeighbours(cmd, kernel);
                kernel.SetBuffer(cmd, Density, solver.Density);
                kernel.SetBuffer(cmd, Pressure, solver.Pressure);
                kernel.SetBuffer(cmd, Statistics, records);
                kernel.SetInt(cmd, ParticleCount, solver.ParticleCount);
                kernel.SetInt(cmd, FirstRange, solver.CellRanges.First);
                kernel.SetInt(cmd, CellCount, solver.CellRanges.Count);
                kernel.SetInt(cmd, GroupCount, Groups(solver.ParticleCount));
                kernel.SetFloat(cmd, RestDensity, settings.RestDensity);
                kernel.SetFloat(cmd, Spacing, settings.Spacing);
                kernel.SetFloat(cmd, HalfStep, 0.5f * solver.LastTimeStep);
                kernel.SetVector(cmd, Potential, AlongWalls(settings.Gravity, settings));
                kernel.SetVector(cmd, PotentialCentre, settings.BodyForce.Centre);
                kernel.SetVector(cmd, PotentialRate, settings.BodyForce.RateSquared);
                kernel.SetVector(cmd, DomainHalfSize, 0.5f * settings.DomainSize);
                DomainBindings.SetFaces(cmd, kernel, settings);
                kernel.DispatchThreads(cmd, solver.ParticleCount);
            }
        }

        private static Vector3 AlongWalls(Vector3 value, in FluidSolverSettings settings)
        {
            FluidAxes axes = settings.Boundaries.Periodic;
            return new Vector3(
                (axes & FluidAxes.X) != 0 ? 0f : value.x,
                (axes & FluidAxes.Y) != 0 ? 0f : value.y,
                (axes & FluidAxes.Z) != 0 ? 0f : value.z);
        }
    }
}
