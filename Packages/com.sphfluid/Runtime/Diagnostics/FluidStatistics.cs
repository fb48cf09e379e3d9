using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The state of a whole liquid at one moment, summed on the GPU (Shaders/Diagnostics/MeasureStatistics.compute). SI, simulation space.
    /// </summary>
    public struct FluidStatistics
    {
        /// <summary>Time since the start [s].</summary>
        public double Time;

        /// <summary>Steps since the start.</summary>
        public long Step;

        /// <summary>Number of particles in the liquid.</summary>
        public int ParticleCount;

        /// <summary>
        /// Slots of <see cref="FluidSolver.ParticleCount"/> without a particle: what has left, of a liquid into which nothing is born.
        /// </summary>
        public int Removed;

        /// <summary>
        /// Particles with a position, velocity or density that is not a finite number. All sums leave them out, and no other counts them.
        /// </summary>
        public int NonFinite;

        /// <summary>Particles outside the domain box by more than half a spacing.</summary>
        public int Escaped;

        /// <summary>Particles whose nearest neighbour is closer than half a spacing.</summary>
        public int Clumped;

        /// <summary>Particles in the place of another, within 1e-6 R.</summary>
        public int Coincident;

        /// <summary>Largest number of neighbours of a particle within R, itself not counted.</summary>
        public int MaxNeighbours;

        /// <summary>Particles that the neighbour grid does not hold in their own cell; 0 in a grid of the present positions.</summary>
        public int Misplaced;

        /// <summary>
        /// Particles that all cells of the neighbour grid hold together; <see cref="ParticleCount"/> in a grid of the present positions.
        /// </summary>
        public long Listed;

        /// <summary>Largest number of particles in a cell of the neighbour grid.</summary>
        public int MaxCellCount;

        /// <summary>Particles within a tenth of a spacing of a wall of the domain, or behind it.</summary>
        public int AtWalls;

        /// <summary>
        /// Particles within a spacing of the domain's walls over what one layer at one particle a dx² would be: a mean over those
        /// particles of how many lie within R, over π κ². About 0.7 to 1 at rest; 0 where no particle is near a wall.
        /// </summary>
        public double WallCrowding;

        /// <summary>
        /// ½ Σ m v² [J], as of half a step before <see cref="Time"/>: leapfrog's velocities live there, and noise near the time step's
        /// border keeps its mean energy only there.
        /// </summary>
        public double KineticEnergy;

        /// <summary>
        /// −Σ m g·x and the body force's ½ Σ m ω² (x − centre)² [J], as of half a step before <see cref="Time"/> as the kinetic energy is:
        /// the sum of both is then constant in free fall. Gravity along a periodic axis has no potential and is left out.
        /// </summary>
        public double PotentialEnergy;

        /// <summary>
        /// Energy of compression of the equation of state, Σ m c² (ln(ρ/ρ0) + ρ0/ρ − 1) where its pressure acts, at <see cref="Time"/> [J].
        /// </summary>
        public double ElasticEnergy;

        /// <summary>Σ m v [kg m/s].</summary>
        public Vector3 Momentum;

        /// <summary>Σ m |v| [kg m/s]: what the momentum is compared with.</summary>
        public double MomentumScale;

        /// <summary>Largest speed [m/s].</summary>
        public double MaxSpeed;

        /// <summary>Mean of max(0, ρ/ρ0 − 1).</summary>
        public double MeanCompression;

        /// <summary>Largest ρ/ρ0.</summary>
        public double MaxDensityRatio;

        /// <summary>Smallest ρ/ρ0.</summary>
        public double MinDensityRatio;

        /// <summary>
        /// Mean of (v_i − mean v of its neighbours)·v_i over mean v², near neighbours counting more by (1 − r²/R²)³: 0 for smooth motion, 1
        /// for velocities at random, more where nearest neighbours move against each other: 1.28 for a checkerboard at κ = 2.
        /// </summary>
        public double Checkerboard;

        /// <summary>Sum of the three energies [J].</summary>
        public double Energy => KineticEnergy + PotentialEnergy + ElasticEnergy;

        /// <summary>√(2 E_kin / Σ m) [m/s].</summary>
        public double RmsSpeed(double particleMass) =>
            System.Math.Sqrt(2.0 * KineticEnergy / System.Math.Max(1e-300, particleMass * (ParticleCount - NonFinite)));
    }
}
