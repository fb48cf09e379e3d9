using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The least body that the liquid moves as it should: three spacings across, and not lighter than a fiftieth of the liquid that would
    /// fill its box and a spacing about it. A particle takes a body for a wall that does not give way, so what is lighter than the
    /// particles about it would be thrown from one to the next.
    /// </summary>
    internal readonly struct FloatingSize
    {
        // Particles in the box of the least body, less rounding: three cubed.
        private const float LeastParticles = 26.9f;

        // Of the liquid in the box and a spacing about it.
        private const float LeastShare = 0.02f;

        // Of gravity: what pulls a smaller body. Archimedes and the water that it carries along make it 2 for a bubble.
        private const float MostPull = 3f;

        // Of the mass of a layer of particles beside a body: more than one side is touched at once.
        private const float LayerMargin = 1.5f;

        private readonly float spacing, density, pull, speed;

        public FloatingSize(in FluidSolverSettings settings)
        {
            spacing = settings.Spacing;
            density = settings.RestDensity;
            speed = settings.MaxSpeed;
            pull = MostPull * Mathf.Max(settings.Gravity.magnitude, 0.5f * speed * speed / settings.DomainSize.magnitude);
        }

        /// <summary>Bounds what a body takes of the liquid's impulses.</summary>
        /// <param name="input">The body.</param>
        /// <param name="size">Edges of the box about its colliders [m].</param>
        /// <param name="mass">Its mass with that of all that moves with it as one [kg].</param>
        /// <returns>Whether it is below the least.</returns>
        public bool Bound(ref FloatingInput input, Vector3 size, float mass)
        {
            bool isSmall = input.InverseMass > 0f && IsSmall(size, mass, spacing);
            input.MostPull = isSmall ? pull : 1e30f;
            input.MostSpeed = isSmall ? speed : 2f * speed;
            input.TurnsPerMetre = 2f / spacing;
            float side = Mathf.Max(size.x * size.y, Mathf.Max(size.y * size.z, size.z * size.x));
            input.Layer = input.InverseMass > 0f ? LayerMargin * density * side * spacing / mass : 0f;
            return isSmall;
        }

        /// <summary>Names a body below the least.</summary>
        public FluidMessage Message(Component source, Vector3 size, float mass)
        {
            float fits = spacing;
            for (int i = 0; i < 50 && IsSmall(size, mass, fits); i++) fits *= 0.9f;
            string finer = IsSmall(size, mass, fits) ? "Make the body larger and heavier"
                : FormattableString.Invariant($"Use a Particle Spacing of {0.95f * fits:g2} m or less, make the body larger or heavier");
            return new FluidMessage(FluidSeverity.Warning, FluidIssue.BodyTooSmall,
                source is Collider collider ? collider.attachedRigidbody : source,
                FormattableString.Invariant($"The body measures {size.x:g2} x {size.y:g2} x {size.z:g2} m and weighs {mass:g2} kg, too ") +
                FormattableString.Invariant($"little for a Particle Spacing of {spacing:g2} m: the liquid carries it along, but it does ") +
                "not float as it should.",
                $"{finer}, or turn Moved By Liquid off in a Fluid Collider.");
        }

        private bool IsSmall(Vector3 size, float mass, float dx)
        {
            Vector3 around = size + 2f * dx * Vector3.one;
            return size.x * size.y * size.z < LeastParticles * dx * dx * dx || mass < LeastShare * density * around.x * around.y * around.z;
        }
    }
}
