using System;

namespace SphFluid.Validation
{
    /// <summary>Momentum, speed and compression of a snapshot, summed in double precision.</summary>
    readonly struct LiquidMotion
    {
        LiquidMotion(Vector3d momentum, double scale, double maxSpeed, double compression)
        {
            Momentum = momentum;
            MomentumScale = scale;
            MaxSpeed = maxSpeed;
            MeanCompression = compression;
        }

        /// <summary>Σ m v [kg m/s].</summary>
        public Vector3d Momentum { get; }

        /// <summary>Σ m |v| [kg m/s].</summary>
        public double MomentumScale { get; }

        /// <summary>Largest speed [m/s]; not a number when a velocity is not.</summary>
        public double MaxSpeed { get; }

        /// <summary>Mean of max(0, ρ/ρ0 − 1).</summary>
        public double MeanCompression { get; }

        public static LiquidMotion Of(FluidSnapshot state, in FluidSolverSettings settings)
        {
            double scale = 0.0, maxSpeed = 0.0, compression = 0.0;
            var momentum = new Vector3d();
            for (int i = 0; i < state.Count; i++)
            {
                var v = new Vector3d(state.Velocities[i]);
                double speed = v.Length;
                scale += settings.ParticleMass * speed;
                momentum += settings.ParticleMass * v;
                maxSpeed = speed <= maxSpeed ? maxSpeed : speed; // not a number stays
                compression += Math.Max(0.0, state.Densities[i] / (double)settings.RestDensity - 1.0);
            }
            return new LiquidMotion(momentum, scale, maxSpeed, compression / Math.Max(1, state.Count));
        }
    }
}
