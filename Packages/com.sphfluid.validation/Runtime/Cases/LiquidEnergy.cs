using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The energies of a state [J], summed on the CPU; <see cref="FluidStatistics"/> has the same sums from the GPU.</summary>
    public readonly struct LiquidEnergy
    {
        private LiquidEnergy(double kinetic, double potential, double elastic)
        {
            Kinetic = kinetic;
            Potential = potential;
            Elastic = elastic;
        }

        /// <summary>½ Σ m v².</summary>
        public double Kinetic { get; }

        /// <summary>−Σ m g·x + ½ Σ m ω² (x − centre)², zero at the centre of the domain.</summary>
        public double Potential { get; }

        /// <summary>Σ m c² (ln(ρ/ρ0) + ρ0/ρ − 1) of p = c² (ρ − ρ0), where pressure acts; c is the speed at which waves run.</summary>
        public double Elastic { get; }

        /// <summary>All three.</summary>
        public double Total => Kinetic + Potential + Elastic;

        /// <summary>The energies of a state.</summary>
        /// <param name="state">The particles.</param>
        /// <param name="settings">Their physics.</param>
        public static LiquidEnergy Of(FluidSnapshot state, in FluidSolverSettings settings)
        {
            double kinetic = 0.0, potential = 0.0, elastic = 0.0;
            Vector3 g = settings.Gravity, rate = settings.BodyForce.RateSquared, centre = settings.BodyForce.Centre;
            for (int i = 0; i < state.Count; i++)
            {
                Vector3 v = state.Velocities[i], p = state.LocalPositions[i];
                kinetic += 0.5 * ((double)v.x * v.x + (double)v.y * v.y + (double)v.z * v.z);
                for (int axis = 0; axis < 3; axis++)
                {
                    double off = (double)p[axis] - centre[axis];
                    potential += -(double)g[axis] * p[axis] + 0.5 * rate[axis] * off * off;
                }
                double ratio = state.Densities[i] / (double)settings.RestDensity;
                bool acts = settings.PressureClamp ? ratio > 1.0 : ratio > 0.0;
                elastic += acts ? Math.Log(ratio) + 1.0 / ratio - 1.0 : 0.0;
            }
            double sound = EffectiveSound(settings);
            return new LiquidEnergy(settings.ParticleMass * kinetic, settings.ParticleMass * potential,
                settings.ParticleMass * sound * sound * elastic);
        }

        /// <summary>
        /// What the force is multiplied with: 6.3.3 as printed multiplies the force density by m where the equation divides by ρ, which is
        /// m ρ times the acceleration; 1 else.
        /// </summary>
        internal static double ForceFactor(in FluidSolverSettings settings) =>
            CaseMethod.IsThesis(settings) && settings.Own<ThesisSettings>().ForceTimesMass
                ? (double)settings.ParticleMass * settings.RestDensity : 1.0;

        /// <summary>Speed at which waves run [m/s].</summary>
        internal static double EffectiveSound(in FluidSolverSettings settings) =>
            CaseSettings.EffectiveSoundSpeed(settings) * Math.Sqrt(ForceFactor(settings));
    }
}
