using System;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What became of a scene.</summary>
    sealed class LeakResult
    {
        public LeakScene Scene;

        /// <summary>Steps that were done.</summary>
        public long Steps;

        /// <summary>Particles that got through the surface.</summary>
        public int Escapes;

        /// <summary>What the solver counted.</summary>
        public FluidCounters Counters;

        /// <summary>Times the surface moved too far in a frame to be followed.</summary>
        public int Jumps;

        /// <summary>Largest speed of any step [m/s].</summary>
        public double MaxSpeed;

        /// <summary>
        /// Largest kinetic and potential energy at the end of a frame over that at the start, heights from the floor of the domain; not a number
        /// where the surface moves and does work.
        /// </summary>
        public double EnergyRatio;

        /// <summary>How it lies at the surface in the end; null where it does not rest.</summary>
        public WallRest? Rest;

        /// <summary>The particles at the end, by id.</summary>
        public FluidParticle[] End;

        /// <summary>
        /// Largest change of the mean velocity along x of those that started at rest, or of those that flowed, over the scene's speed; not a number
        /// where the domain is not periodic along x, so that more than friction acts.
        /// </summary>
        public double Drag
        {
            get
            {
                if ((Scene.Settings.Boundaries.Periodic & FluidAxes.X) == 0)
                    return double.NaN;
                return Enumerable.Range(0, End.Length).GroupBy(i => Scene.Particles[i].VelT0.x)
                    .Max(alike => Math.Abs(alike.Average(i => (double)End[i].VelT0.x) - alike.Key)) / Scene.Speed;
            }
        }

        /// <summary>Why it failed; empty where it holds. Shortened steps and fallbacks are no failures: their ways are proved free too.</summary>
        public string Failure =>
            Escapes > 0 ? "escapes" :
            Counters.NonFinite > 0 ? "not finite" :
            Counters.Squeezed > 0 ? "squeezed" :
            Jumps > 0 ? "jumps" : "";
    }
}
