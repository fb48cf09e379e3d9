using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Counts a liquid's particles by speed and by distance from kept places: <see cref="SpeedCounts"/>.</summary>
    internal sealed class MeasureSpeedsPass : ComputePass
    {
        private static readonly int Particles = Id("_Particles");
        private static readonly int Places = Id("_Places");
        private static readonly int PlacesOut = Id("_PlacesOut");
        private static readonly int Claims = Id("_PlaceClaims");
        private static readonly int ClaimsOut = Id("_PlaceClaimsOut");
        private static readonly int PlaceCount = Id("_PlaceCount");
        private static readonly int Counts = Id("_SpeedCounts");
        private static readonly int Counters = Id("_Counters");
        private static readonly int ParticleCount = Id("_ParticleCount");
        private static readonly int Potential = Id("_Potential");
        private static readonly int PotentialCentre = Id("_PotentialCentre");
        private static readonly int PotentialRate = Id("_PotentialRate");
        private static readonly int PotentialLow = Id("_PotentialLow");
        private static readonly int Density = Id("_Density");
        private static readonly int RestDensity = Id("_RestDensity");

        private static readonly uint[] Zeros = new uint[SpeedCounts.Size];

        private readonly ComputeKernel measure, clear, keep, distances;

        public MeasureSpeedsPass(FluidShaderSet shaders)
            : base(shaders, "MeasureSpeeds")
        {
            measure = Kernel();
            clear = Kernel("ClearPlaces");
            keep = Kernel("KeepPlaces");
            distances = Kernel("MeasureDistances");
        }

        /// <summary>Records the counts of the present state.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="counts">Receives <see cref="SpeedCounts.Size"/> numbers.</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, GraphicsBuffer counts)
        {
            FluidSolverSettings settings = solver.Settings;
            using (Sample(cmd))
            {
                cmd.SetBufferData(counts, Zeros);
                measure.SetBuffer(cmd, Particles, solver.Particles);
                measure.SetBuffer(cmd, Counts, counts);
                measure.SetBuffer(cmd, Counters, solver.State.Published.Counters);
                measure.SetBuffer(cmd, Density, solver.Density);
                measure.SetFloat(cmd, RestDensity, settings.RestDensity);
                measure.SetInt(cmd, ParticleCount, solver.ParticleCount);
                measure.SetVector(cmd, Potential, settings.Gravity);
                measure.SetVector(cmd, PotentialCentre, settings.BodyForce.Centre);
                measure.SetVector(cmd, PotentialRate, settings.BodyForce.RateSquared);
                measure.SetFloat(cmd, PotentialLow, (float)LiquidPotential.Lowest(settings));
                measure.DispatchThreads(cmd, solver.ParticleCount);
            }
        }

        /// <summary>Records where the particles are, by id.</summary>
        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="places">Receives float4 a particle, by id modulo their number.</param>
        /// <param name="claims">As many numbers.</param>
        public void RecordPlaces(CommandBuffer cmd, FluidSolver solver, GraphicsBuffer places, GraphicsBuffer claims)
        {
            using (Sample(cmd))
            {
                clear.SetBuffer(cmd, ClaimsOut, claims);
                clear.SetInt(cmd, PlaceCount, places.count);
                clear.DispatchThreads(cmd, places.count);
                keep.SetBuffer(cmd, Particles, solver.Particles);
                keep.SetBuffer(cmd, ClaimsOut, claims);
                keep.SetInt(cmd, PlaceCount, places.count);
                keep.SetBuffer(cmd, PlacesOut, places);
                keep.SetInt(cmd, ParticleCount, solver.ParticleCount);
                keep.DispatchThreads(cmd, solver.ParticleCount);
            }
        }

        /// <summary>Records the counts by distance from kept places, after <see cref="Record"/>.</summary>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="places">What <see cref="RecordPlaces"/> wrote.</param>
        /// <param name="claims">And that.</param>
        /// <param name="counts">Receives its part of the numbers.</param>
        public void RecordDistances(CommandBuffer cmd, FluidSolver solver, GraphicsBuffer places, GraphicsBuffer claims,
            GraphicsBuffer counts)
        {
            using (Sample(cmd))
            {
                DomainBindings.SetPeriodic(cmd, distances, solver.Settings);
                distances.SetBuffer(cmd, Particles, solver.Particles);
                distances.SetBuffer(cmd, Places, places);
                distances.SetBuffer(cmd, Claims, claims);
                distances.SetInt(cmd, PlaceCount, places.count);
                distances.SetBuffer(cmd, Counts, counts);
                distances.SetInt(cmd, ParticleCount, solver.ParticleCount);
                distances.DispatchThreads(cmd, solver.ParticleCount);
            }
        }
    }
}
