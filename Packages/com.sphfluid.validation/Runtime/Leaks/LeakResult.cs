using System;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of leaks.csv: what became of a scene.</summary>
    internal sealed class LeakResult : MeasuredRow
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<LeakResult> Format = new TableFormat<LeakResult>("leaks.csv")
            .Text("scene", r => r.Scene.Name)
            .Number("speed_m_s", r => r.Scene.Speed)
            .Count("particles", r => r.Scene.Particles.Length)
            .Count("triangles", r => r.Scene.Bodies.Sum(b => b.Surface.Length / 3))
            .Count("frames", r => r.Scene.Frames)
            .Count("steps", r => r.Steps)
            .Count("escapes", r => r.Escapes)
            .Text("failure", r => r.Failure)
            .Count("contacts", r => r.Counters.Contacts)
            .Count("fallbacks", r => r.Counters.ContactFallbacks)
            .Count("squeezed", r => r.Counters.Squeezed)
            .Count("overlaps", r => r.Counters.Overlaps)
            .Count("shortened", r => r.Counters.ShortenedSteps)
            .Count("jumps", r => r.Jumps)
            .Count("non_finite", r => r.Counters.NonFinite)
            .Number("max_speed_m_s", r => r.MaxSpeed)
            .Number("energy_ratio", r => r.EnergyRatio)
            .Number("first_layer_dx", r => r.Rest?.FirstLayer ?? double.NaN)
            .Number("pressed_share", r => r.Rest?.Pressed ?? double.NaN)
            .Number("held_share", r => r.Rest?.Held ?? double.NaN)
            .Number("drag", r => r.Drag)
            .Text("device", r => r.Device)
            .Text("date", r => r.Date);

        public LeakScene Scene;

        /// <summary>Steps that were done.</summary>
        public long Steps;

        /// <summary>Particles that got through a surface.</summary>
        public int Escapes;

        /// <summary>What the solver counted.</summary>
        public FluidCounters Counters;

        /// <summary>Times a surface moved too far in a frame to be followed.</summary>
        public int Jumps;

        /// <summary>Largest speed of any step [m/s].</summary>
        public double MaxSpeed;

        /// <summary>
        /// Largest kinetic and potential energy at the end of a frame over that at the start, heights from the floor of the domain; not a
        /// number where a surface moves and does work.
        /// </summary>
        public double EnergyRatio;

        /// <summary>How it lies at the surface in the end; null where it does not rest.</summary>
        public WallRest? Rest;

        /// <summary>The particles at the end, by id.</summary>
        public FluidParticle[] End;

        /// <summary>
        /// Largest change of the mean velocity along x of those that started at rest, or of those that flowed, over the scene's speed; not
        /// a number where the domain is not periodic along x, so that more than friction acts.
        /// </summary>
        public double Drag
        {
            get
            {
                if ((Scene.Settings.Boundaries.Periodic & FluidAxes.X) == 0) return double.NaN;
                return Enumerable.Range(0, End.Length).GroupBy(i => Scene.Particles[i].VelT0.x)
                    .Max(alike => Math.Abs(alike.Average(i => (double)End[i].VelT0.x) - alike.Key)) / Scene.Speed;
            }
        }

        /// <summary>
        /// Why it failed; empty where it holds. Shortened steps and fallbacks are no failures: their paths are proved free too.
        /// </summary>
        public string Failure =>
            Escapes > (Scene.MaySqueeze ? Counters.Squeezed : 0) ? "escapes" :
            Counters.NonFinite > 0 ? "not finite" :
            Counters.Squeezed > 0 && !Scene.MaySqueeze ? "squeezed" :
            Jumps > 0 ? "jumps" : "";

        /// <summary>For progress lines.</summary>
        public override string ToString()
        {
            string speed = Scene.Speed > 0.0 ? string.Format(CultureInfo.InvariantCulture, " at {0:G4} m/s", Scene.Speed) : "";
            string end = Failure.Length == 0 ? "holds" : "fails: " + Failure;
            return $"{Scene.Name}{speed}: {end}; {Escapes} escapes of {Scene.Particles.Length} particles in {Steps} steps.";
        }
    }
}
