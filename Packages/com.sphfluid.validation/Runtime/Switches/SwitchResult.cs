using System;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Where a <see cref="SwitchExperiment"/> ended.</summary>
    public sealed class SwitchResult
    {
        internal SwitchResult(FluidSolver solver)
        {
            Settings = solver.Settings;
            Particles = Read<FluidParticle>(solver.Particles, solver.ParticleCount);
            Density = Read<float>(solver.Density, solver.ParticleCount);
            Pressure = Read<float>(solver.Pressure, solver.ParticleCount);
            Counters = solver.ReadCountersNow();
        }

        /// <summary>Constants of the run.</summary>
        public FluidSolverSettings Settings { get; }

        /// <summary>The particles.</summary>
        public FluidParticle[] Particles { get; }

        /// <summary>Density of each [kg/m³].</summary>
        public float[] Density { get; }

        /// <summary>Pressure of each as equation (10) gives it [Pa].</summary>
        public float[] Pressure { get; }

        /// <summary>Events of the run.</summary>
        public FluidCounters Counters { get; }

        /// <summary>Mean height of the particles over the floor [m].</summary>
        public double MeanHeight => Particles.Average(p => (double)p.Position.y) + 0.5 * Settings.DomainSize.y;

        /// <summary>Mean speed [m/s].</summary>
        public double MeanSpeed => Particles.Average(p => (double)p.VelT1.magnitude);

        /// <summary>Root of the mean square distance from the centre of mass [m].</summary>
        public double Extent
        {
            get
            {
                Vector3 centre = Vector3.zero;
                foreach (FluidParticle p in Particles) centre += p.Position / Particles.Length;
                return Math.Sqrt(Particles.Average(p => (double)(p.Position - centre).sqrMagnitude));
            }
        }

        /// <summary>Share of particles whose nearest neighbour is closer than a part of the spacing.</summary>
        /// <param name="part">Part of the spacing.</param>
        /// <returns>0 to 1.</returns>
        public double Clumped(float part)
        {
            float limit = part * Settings.Spacing * (part * Settings.Spacing);
            int near = 0;
            for (int i = 0; i < Particles.Length; i++)
            {
                bool found = false;
                for (int j = 0; j < Particles.Length && !found; j++)
                {
                    found = j != i && (Particles[i].Position - Particles[j].Position).sqrMagnitude < limit;
                }
                near += found ? 1 : 0;
            }
            return near / (double)Particles.Length;
        }

        /// <summary>Slope of the pressure over depth over ρ0 g, least squares, the surface and the floor's layers left out.</summary>
        public double PressureSlope
        {
            get
            {
                double floor = -0.5 * Settings.DomainSize.y;
                double top = Particles.Max(p => p.Position.y);
                double low = floor + 3.0 * Settings.Spacing, high = top - 3.0 * Settings.Spacing;
                double n = 0, sy = 0, sp = 0, syy = 0, syp = 0;
                for (int i = 0; i < Particles.Length; i++)
                {
                    double y = Particles[i].Position.y;
                    if (y < low || y > high) continue;
                    n++;
                    sy += y;
                    sp += Pressure[i];
                    syy += y * y;
                    syp += y * Pressure[i];
                }
                double slope = (n * syp - sy * sp) / (n * syy - sy * sy);
                return slope / (Settings.RestDensity * Settings.Gravity.y);
            }
        }

        private static T[] Read<T>(GraphicsBuffer buffer, int count) where T : struct
        {
            var data = new T[count];
            buffer.GetData(data);
            return data;
        }
    }
}
