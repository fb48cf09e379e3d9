using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Sums over the particles of a snapshot, as <see cref="FluidVitals"/> defines them, in double precision.</summary>
    readonly struct StabilityEnergy
    {
        StabilityEnergy(double kinetic, double potential, double elastic, double maxSpeed, double compression, Vector3d momentum, double scale)
        {
            Kinetic = kinetic;
            Potential = potential;
            Elastic = elastic;
            MaxSpeed = maxSpeed;
            MeanCompression = compression;
            Momentum = momentum;
            MomentumScale = scale;
        }

        /// <summary>½ Σ m v² [J].</summary>
        public double Kinetic { get; }

        /// <summary>Against gravity, above the lowest corner of the domain, and in the body force [J].</summary>
        public double Potential { get; }

        /// <summary>Σ m c² (ln(ρ/ρ0) + ρ0/ρ − 1) where the pressure acts [J].</summary>
        public double Elastic { get; }

        public double Total => Kinetic + Potential + Elastic;

        /// <summary>Largest speed [m/s]; not a number when a velocity is not.</summary>
        public double MaxSpeed { get; }

        /// <summary>Mean of max(0, ρ/ρ0 − 1).</summary>
        public double MeanCompression { get; }

        /// <summary>Σ m v and Σ m |v| [kg m/s].</summary>
        public Vector3d Momentum { get; }

        public double MomentumScale { get; }

        public static StabilityEnergy Of(FluidSnapshot state, in FluidSolverSettings settings)
        {
            double mass = settings.ParticleMass, rest = settings.RestDensity;
            double sound = StabilityConstants.EffectiveSound(settings);
            double kinetic = 0.0, potential = 0.0, elastic = 0.0, maxSpeed = 0.0, compression = 0.0, scale = 0.0;
            var momentum = new Vector3d();
            double lowest = Lowest(settings);
            for (int i = 0; i < state.Count; i++)
            {
                Vector3 p = state.LocalPositions[i];
                var v = new Vector3d(state.Velocities[i]);
                double speed = v.Length;
                kinetic += 0.5 * mass * speed * speed;
                scale += mass * speed;
                momentum += mass * v;
                maxSpeed = speed <= maxSpeed ? maxSpeed : speed; // not a number stays
                potential += mass * (lowest - new Vector3d(settings.Gravity).Dot(new Vector3d(p)) + Field(p, settings.BodyForce));
                double ratio = state.Densities[i] / rest;
                compression += Math.Max(0.0, ratio - 1.0);
                if (ratio > 0.0 && (ratio > 1.0 || !settings.PressureClamp))
                    elastic += mass * sound * sound * (Math.Log(ratio) + 1.0 / ratio - 1.0);
            }
            return new StabilityEnergy(kinetic, potential, elastic, maxSpeed, compression / Math.Max(1, state.Count), momentum, scale);
        }

        static double Field(Vector3 p, in FluidBodyForce force)
        {
            Vector3 d = p - force.Centre;
            return 0.5 * (force.RateSquared.x * d.x * d.x + force.RateSquared.y * d.y * d.y + force.RateSquared.z * d.z * d.z);
        }

        // Gravity's potential at the lowest corner, to be taken off: energies then start at zero there.
        static double Lowest(in FluidSolverSettings settings) =>
            0.5 * (Math.Abs(settings.Gravity.x) * settings.DomainSize.x + Math.Abs(settings.Gravity.y) * settings.DomainSize.y +
                Math.Abs(settings.Gravity.z) * settings.DomainSize.z);
    }
}
