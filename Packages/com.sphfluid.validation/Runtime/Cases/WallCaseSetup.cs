using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What the cases between walls share: thin periodic boxes, columns at rest, checks.</summary>
    internal static class WallCaseSetup
    {
        /// <summary>
        /// Least number of particles along a periodic axis: three cells of R, κ = 2.5 needs 8; two of 2R where the text as
        /// printed has its octant search.
        /// </summary>
        public static int PeriodicCount(in CaseParameters parameters)
        {
            int radii = parameters.Method.Kind == FluidMethodKind.ThesisPrinted ? 4 : 3;
            return (int)Math.Ceiling(radii * parameters.SupportRatio - 1e-6);
        }

        /// <summary>Checks the factors that every case has.</summary>
        /// <exception cref="ArgumentException">One cannot be run.</exception>
        public static void Require(in CaseParameters parameters, string name, int leastResolution)
        {
            if (parameters.Method == null) throw new ArgumentException($"{name}: no method is given.");
            if (parameters.Resolution < leastResolution)
            {
                throw new ArgumentException(
                    $"{name}: the resolution is {parameters.Resolution}; it must be {leastResolution} particles or more.");
            }
            if (!(parameters.Jitter >= 0.0) || parameters.Jitter > 0.3)
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"{name}: the jitter is {parameters.Jitter}; it must be 0 to 0.3 spacings."));
            }
        }

        /// <summary>
        /// Height at rest of what is at y in a column of rest density and depth H: c² = m g H compresses what is above it to
        /// m H ln(1 + (H − y)/(m H)), as it does the whole to m H ln(1 + 1/m).
        /// </summary>
        public static double Settled(double y, double depth, double m) =>
            m * depth * (Math.Log(1.0 + 1.0 / m) - Math.Log(1.0 + (depth - y) / (m * depth)));

        /// <summary>Compresses a column that stands at y = 0 as at rest, and puts it on the floor of a domain.</summary>
        public static void Settle(List<Vector3> positions, double depth, double m, Vector3 domainSize)
        {
            for (int i = 0; i < positions.Count; i++)
            {
                Vector3 p = positions[i];
                positions[i] = new Vector3(p.x, (float)Settled(p.y, depth, m) - 0.5f * domainSize.y, p.z);
            }
        }

        /// <summary>m of <see cref="Settled"/>, c² = m U², with the speed of sound that the liquid has in its steps: U² is g H.</summary>
        public static double Stiffness(in CaseParameters parameters, in FluidSolverSettings settings)
        {
            double softening = CaseSettings.EffectiveSoundSpeed(settings) / settings.SoundSpeed;
            return parameters.SoundSpeedRatio * parameters.SoundSpeedRatio * softening * softening;
        }

        /// <summary>
        /// A particle at rest on a place of the start, jittered, and inside the domain: wrapped along periodic axes, kept from walls.
        /// </summary>
        public static FluidParticle Particle(Vector3 place, uint id, double deviation, System.Random random,
            in FluidSolverSettings settings)
        {
            Vector3 position = place +
                (float)deviation * new Vector3(CaseLattice.Normal(random), CaseLattice.Normal(random), CaseLattice.Normal(random));
            FluidAxes periodic = settings.Boundaries.Periodic;
            for (int axis = 0; axis < 3; axis++)
            {
                float length = settings.DomainSize[axis];
                float edge = 0.5f * length - 0.01f * settings.Spacing;
                position[axis] = ((int)periodic & (1 << axis)) != 0
                    ? Mathf.Repeat(position[axis] + 0.5f * length, length) - 0.5f * length
                    : Mathf.Clamp(position[axis], -edge, edge);
            }
            return new FluidParticle(position, Vector3.zero, id);
        }

        /// <summary>Jitters positions and makes particles at rest of them.</summary>
        public static FluidParticle[] AtRest(List<Vector3> positions, in CaseParameters parameters, double spacing, Vector3 domainSize)
        {
            CaseLattice.Jitter(positions, parameters.Jitter * spacing, parameters.Seed, 0.4999f * domainSize);
            return CaseLattice.Particles(positions);
        }
    }
}
