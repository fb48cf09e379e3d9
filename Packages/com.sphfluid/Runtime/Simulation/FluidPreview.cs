using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What a simulation would start with, known before it does.</summary>
    internal sealed class FluidPreview
    {
        /// <summary>Of a simulation that may start.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">How it would start.</param>
        /// <param name="collision">Its colliders, gathered.</param>
        public FluidPreview(in FluidSpec spec, FluidStart start, CollisionScene collision)
        {
            Constants = start.Constants;
            Choice = start.Choice;
            HasBodies = collision.Solids.Count > 0;
            Particles = start.Count;
            Vector3 gravity = spec.LocalGravity;
            Depth = gravity.sqrMagnitude > 0f ? FluidConstants.DepthAtRest(spec, start, gravity) : 0f;
            try
            {
                GpuBytes = BytesOf(start.Resolve(spec), start, collision);
            }
            catch (FluidDeviceException exception)
            {
                Lack = exception.Message;
            }
        }

        /// <summary>The solver's constants.</summary>
        public FluidSolverSettings Constants { get; }

        /// <summary>The method that Automatic would pick by what is known; null where the method is given.</summary>
        public FluidMethodChoice Choice { get; }

        /// <summary>Whether there are triangles in the domain.</summary>
        public bool HasBodies { get; }

        /// <summary>Number of particles.</summary>
        public long Particles { get; }

        /// <summary>Depth of the liquid at rest, were its volume spread over the domain [m]; 0 without gravity.</summary>
        public float Depth { get; }

        /// <summary>
        /// GPU memory after the start [bytes], colliders included, as the running liquid reports it; 0 where <see cref="Lack"/> says why.
        /// </summary>
        public long GpuBytes { get; }

        /// <summary>Why the device cannot hold the liquid; null where it can.</summary>
        public string Lack { get; }

        private static long BytesOf(in FluidSpec spec, FluidStart start, CollisionScene collision)
        {
            FluidMethod method = FluidMethods.Get(spec.Method);
            FluidSolverSettings settings = method.Prepare(start.Constants);
            (long colliders, int bodies) = method.Has(FluidMethodFeatures.BodyContact) ? PlanBodies(settings, collision)
                : (collision.PlannedBytes, 0);
            int slots = LoadedParticles.SlotsFor(method, (int)Math.Min(start.Count, int.MaxValue), spec.FixedSlots);
            SleepRule? sleep = SleepingParts.RuleFor(spec, settings);
            return method.PlannedBytes(settings, slots, bodies > 0, sleep) + colliders + FluidPace.PlannedBytes(spec);
        }

        private static (long bytes, int bodies) PlanBodies(in FluidSolverSettings settings, CollisionScene collision)
        {
            var bodies = new CollisionBodies(settings);
            try
            {
                return bodies.Plan(collision.Solids);
            }
            finally
            {
                bodies.Dispose();
            }
        }
    }
}
