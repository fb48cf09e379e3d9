using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// A step of the Robust method by all pairs in double precision; kernel, walls and lattice sums by <see cref="StandardReference"/>.
    /// </summary>
    public sealed class RobustReference
    {
        private readonly FluidSolverSettings settings;
        private readonly double dt, kick, response, radius, rest, ratio;
        private readonly bool keepsLists;
        private readonly double[] multipliers;
        private readonly bool[,] listed; // pairs nearer than R at the sort; others act after the next one
        private readonly Double3[] starts, velocities, displacements, places;

        /// <param name="particles">Particles when the step begins.</param>
        /// <param name="settings">Constants of the Robust method.</param>
        /// <param name="dt">Length of the step [s].</param>
        /// <param name="kick">How far forces from outside take the velocities [s].</param>
        /// <param name="keepsLists">Whether neighbours are listed where the step begins, not where it is predicted to end.</param>
        public RobustReference(IReadOnlyList<FluidParticle> particles, in FluidSolverSettings settings, double dt, double kick,
            bool keepsLists)
        {
            this.keepsLists = keepsLists;
            this.settings = settings;
            this.dt = dt;
            this.kick = kick;
            response = StandardReference.Response(settings);
            radius = settings.SupportRadius;
            rest = settings.RestDensity;
            ratio = settings.ParticleMass / (rest * response);
            multipliers = new double[particles.Count];
            listed = new bool[particles.Count, particles.Count];
            starts = new Double3[particles.Count];
            velocities = new Double3[particles.Count];
            displacements = new Double3[particles.Count];
            places = new Double3[particles.Count];
            for (int i = 0; i < particles.Count; i++)
            {
                starts[i] = particles[i].Position;
                velocities[i] = particles[i].VelT0;
            }
        }

        /// <summary>Where the particles end, not brought back into the box along periodic axes [m].</summary>
        public IReadOnlyList<Double3> Places => places;

        /// <summary>Their velocities at the end [m/s].</summary>
        public IReadOnlyList<Double3> Velocities => velocities;

        /// <summary>The pressure that pushes a particle, where it ends [Pa].</summary>
        public double Pressure(int i)
        {
            double sum = rest * StandardReference.Walls(places[i], settings) +
                settings.ParticleMass * StandardReference.Kernel(0.0, radius);
            for (int j = 0; j < places.Length; j++)
            {
                double distance = Apart(i, j, places).Length;
                if (j != i && distance < radius) sum += settings.ParticleMass * StandardReference.Kernel(distance, radius);
            }
            double density = rest + (sum - rest) / response;
            return -multipliers[i] / (rest * dt * dt) * density * density;
        }

        /// <summary>Takes the step.</summary>
        /// <param name="iterations">Iterations.</param>
        /// <param name="viscosity">Dynamic viscosity that acts [Pa s].</param>
        /// <param name="sound">Speed of sound of the parting of close pairs [m/s].</param>
        public void Step(int iterations, double viscosity, double sound)
        {
            if (keepsLists) List(starts);
            Predict();
            if (!keepsLists) List(places);
            var predicted = (Double3[])places.Clone();
            FluidSolverSettings pairs = settings.WithSoundSpeed((float)sound);
            for (int n = 0; n < iterations; n++) Iterate(predicted, n == 0 ? Dragged(viscosity, pairs) : new Double3[places.Length]);
            for (int i = 0; i < places.Length; i++) velocities[i] = displacements[i] / dt;
        }

        private void List(Double3[] at)
        {
            for (int i = 0; i < at.Length; i++)
                for (int j = 0; j < at.Length; j++) listed[i, j] = i != j && Apart(i, j, at).Length < radius;
        }

        private void Predict()
        {
            double shell = 0.25 * settings.Spacing;
            Vector3 half = 0.5f * settings.DomainSize, period = settings.PeriodLength;
            for (int i = 0; i < starts.Length; i++)
            {
                Double3 v = velocities[i] + kick * (Double3)settings.Gravity;
                double[] x = { starts[i].X, starts[i].Y, starts[i].Z }, w = { v.X, v.Y, v.Z };
                for (int axis = 0; axis < 3; axis++)
                {
                    if (period[axis] > 0f) continue;
                    double low = -Math.Max(x[axis] + half[axis] - shell, 0.0) / dt, high = Math.Max(half[axis] - x[axis] - shell, 0.0) / dt;
                    w[axis] = Math.Min(Math.Max(w[axis], low), high);
                }
                velocities[i] = new Double3(w[0], w[1], w[2]);
                displacements[i] = dt * velocities[i];
                places[i] = starts[i] + displacements[i];
            }
        }

        private Double3 Apart(int i, int j, Double3[] at)
        {
            Double3 d = at[i] - at[j];
            Vector3 period = settings.PeriodLength;
            double Nearest(double x, double length) => length > 0.0 ? x - length * Math.Round(x / length) : x;
            return new Double3(Nearest(d.X, period.x), Nearest(d.Y, period.y), Nearest(d.Z, period.z));
        }

        private Double3 WallGradient(int i)
        {
            double h = 1e-4 * settings.Spacing;
            double Walls(double x, double y, double z) => StandardReference.Walls(places[i] + new Double3(x, y, z), settings);
            return new Double3(Walls(h, 0, 0) - Walls(-h, 0, 0), Walls(0, h, 0) - Walls(0, -h, 0), Walls(0, 0, h) - Walls(0, 0, -h)) /
                (2.0 * h);
        }

        private void Iterate(Double3[] predicted, Double3[] accelerations)
        {
            int count = places.Length;
            double relaxation = settings.Own<RobustSettings>().Relaxation, reach = settings.SoundSpeed * dt,
                compliance = 1.0 / (reach * reach);
            var changes = new double[count];
            var walls = new Double3[count];
            for (int i = 0; i < count; i++)
            {
                double sum = rest * StandardReference.Walls(places[i], settings) +
                    settings.ParticleMass * StandardReference.Kernel(0.0, radius);
                walls[i] = WallGradient(i);
                Double3 gradient = walls[i] / response;
                double squares = 0.0;
                for (int j = 0; j < count; j++)
                {
                    Double3 d = Apart(i, j, places);
                    if (!listed[i, j] || d.Length >= radius) continue;
                    sum += settings.ParticleMass * StandardReference.Kernel(d.Length, radius);
                    Double3 slope = ratio * StandardReference.Slope(d.Length, radius) / d.Length * d;
                    gradient += slope;
                    squares += slope.X * slope.X + slope.Y * slope.Y + slope.Z * slope.Z;
                }
                double constraint = (sum / rest - 1.0) / response;
                double stiffness = gradient.X * gradient.X + gradient.Y * gradient.Y + gradient.Z * gradient.Z + squares;
                double next =
                    Math.Min(0.0, multipliers[i] - relaxation * (constraint + compliance * multipliers[i]) / (stiffness + compliance));
                changes[i] = next - multipliers[i];
                multipliers[i] = next;
            }
            var moved = new Double3[count];
            for (int i = 0; i < count; i++)
            {
                moved[i] = changes[i] / response * walls[i] + dt * dt * accelerations[i];
                for (int j = 0; j < count; j++)
                {
                    Double3 d = Apart(i, j, places);
                    if (!listed[i, j] || d.Length >= radius) continue;
                    moved[i] += (changes[i] + changes[j]) * ratio * StandardReference.Slope(d.Length, radius) / d.Length * d;
                }
            }
            for (int i = 0; i < count; i++)
            {
                displacements[i] += moved[i];
                places[i] = Shelled(starts[i] + displacements[i], predicted[i]);
                displacements[i] = places[i] - starts[i];
            }
        }

        // No nearer to a face than the shell, or than it was predicted.
        private Double3 Shelled(Double3 p, Double3 predicted)
        {
            double shell = 0.25 * settings.Spacing;
            Vector3 half = 0.5f * settings.DomainSize, period = settings.PeriodLength;
            double Within(double x, double expected, double reach, double length) => length > 0.0 ? x
                : Math.Min(Math.Max(x, Math.Min(shell - reach, expected)), Math.Max(reach - shell, expected));
            return new Double3(Within(p.X, predicted.X, half.x, period.x), Within(p.Y, predicted.Y, half.y, period.y),
                Within(p.Z, predicted.Z, half.z, period.z));
        }

        // What viscosity and the parting of close pairs do where the particles are predicted.
        private Double3[] Dragged(double viscosity, in FluidSolverSettings pairs)
        {
            var sums = new Double3[places.Length];
            for (int i = 0; i < places.Length; i++)
            {
                for (int j = 0; j < places.Length; j++)
                {
                    Double3 d = Apart(i, j, places), relative = velocities[i] - velocities[j];
                    if (!listed[i, j] || d.Length >= radius) continue;
                    sums[i] += 2.0 * viscosity / rest * ratio * StandardReference.Slope(d.Length, radius) / d.Length * relative;
                    sums[i] += StandardReference.Parting(d, relative, pairs);
                }
            }
            return sums;
        }
    }
}
