using System;

namespace SphFluid
{
    /// <summary>What limits a time step.</summary>
    public enum TimeStepLimit
    {
        /// <summary>Pressure waves: dt ≤ C R / (c + v).</summary>
        Acoustic,
        /// <summary>The displacement of a particle: v dt ≤ 0.4 dx.</summary>
        Speed,
        /// <summary>Explicit viscosity: ν dt ≤ C R².</summary>
        Viscosity,
        /// <summary>The penalty walls' spring: k_w dt² ≤ 4 − 2 c_w dt.</summary>
        Walls,
        /// <summary>The liquid's weight, which a fixed number of iterations must carry.</summary>
        Weight,
        /// <summary>Capillary waves: dt ≤ 0.2 √(ρ dx³/σ).</summary>
        SurfaceTension,
    }

    /// <summary>
    /// The largest stable time step of a liquid and what limits it. The acoustic limit is the border itself, of which a step is a
    /// fraction; the others are kept with a margin.
    /// </summary>
    public readonly struct TimeStepAdvice
    {
        /// <summary>
        /// Displacement of a particle in a step over the spacing that is advised: it comes near each wall before it is through.
        /// </summary>
        public const double SpeedLimit = 0.4;

        /// <summary>Largest stable step by the speed of sound [s]; infinite where it does not act.</summary>
        public readonly double Acoustic;

        /// <summary>Largest step that is advised by the fastest particle [s]; infinite for liquid at rest.</summary>
        public readonly double Speed;

        /// <summary>Largest stable step by viscosity [s]; infinite where it does not act.</summary>
        public readonly double Viscosity;

        /// <summary>Largest stable step by the stiffness of walls [s]; infinite where it does not act.</summary>
        public readonly double Walls;

        /// <summary>
        /// Largest step in which the iterations of a method carry the liquid's weight [s]; infinite where it does not act.
        /// </summary>
        public readonly double Weight;

        /// <summary>Largest stable step by surface tension [s]; infinite without any.</summary>
        public readonly double SurfaceTension;

        /// <summary>Step at the border of stability that viscosity sets [s]; <see cref="Viscosity"/> keeps about half of it.</summary>
        public readonly double ViscosityBorder;

        /// <summary>The effective speed of sound that the limits are of [m/s].</summary>
        public readonly double SoundSpeed;

        /// <summary>The fastest speed that the limits are of [m/s].</summary>
        public readonly double MaxSpeed;

        /// <summary>The kinematic viscosity that the limits are of [m²/s].</summary>
        public readonly double KinematicViscosity;

        /// <summary>
        /// Whether viscosity is solved for, so that <see cref="Viscosity"/> is no limit of stability but of the work that is allowed.
        /// </summary>
        public readonly bool ViscosityIsImplicit;

        /// <summary>The limits of a liquid, each the largest step that it allows [s].</summary>
        internal TimeStepAdvice(double acoustic, double speedStep, double viscous, double viscousBorder, double walls, double sound,
            double maxSpeed, double kinematic,
            bool isImplicit = false, double weight = double.PositiveInfinity, double capillary = double.PositiveInfinity)
        {
            Acoustic = acoustic;
            Speed = speedStep;
            Viscosity = viscous;
            ViscosityBorder = viscousBorder;
            Walls = walls;
            SoundSpeed = sound;
            MaxSpeed = maxSpeed;
            KinematicViscosity = kinematic;
            ViscosityIsImplicit = isImplicit;
            Weight = weight;
            SurfaceTension = capillary;
        }

        /// <summary>The step in which a particle moves by <see cref="SpeedLimit"/> spacings [s]; infinite at rest.</summary>
        internal static double SpeedStep(double spacing, double speed) => speed > 0.0 ? SpeedLimit * spacing / speed
            : double.PositiveInfinity;

        /// <summary>The step of ν dt/R² = <paramref name="limit"/> [s]; infinite without viscosity.</summary>
        internal static double ViscousStep(double limit, double radius, double kinematic) =>
            kinematic > 0.0 ? limit * radius * radius / kinematic : double.PositiveInfinity;

        /// <summary>The smallest of the limits [s].</summary>
        public double Largest =>
            Math.Min(Math.Min(Math.Min(Acoustic, Speed), Math.Min(Viscosity, Walls)), Math.Min(Weight, SurfaceTension));

        /// <summary>The limit that is the smallest.</summary>
        public TimeStepLimit Limit
        {
            get
            {
                double largest = Largest;
                return largest == Acoustic ? TimeStepLimit.Acoustic
                    : largest == Speed ? TimeStepLimit.Speed
                    : largest == Viscosity ? TimeStepLimit.Viscosity
                    : largest == Walls ? TimeStepLimit.Walls
                    : largest == Weight ? TimeStepLimit.Weight
                    : TimeStepLimit.SurfaceTension;
            }
        }

        /// <summary>What a limit comes from, in a word or three: "speed of sound".</summary>
        internal static string NameOf(TimeStepLimit limit)
        {
            switch (limit)
            {
                case TimeStepLimit.Acoustic: return "speed of sound";
                case TimeStepLimit.Speed: return "fastest particle";
                case TimeStepLimit.Viscosity: return "viscosity";
                case TimeStepLimit.Weight: return "weight of the liquid";
                case TimeStepLimit.SurfaceTension: return "surface tension";
                default: return "stiffness of walls";
            }
        }

        /// <summary>The step to take: a fraction of the acoustic limit, and no more than the others, which have their margin.</summary>
        /// <param name="fraction">Of the acoustic limit; 0.75 by default in a profile.</param>
        /// <returns>Its length [s].</returns>
        public double Step(double fraction) =>
            Math.Min(Math.Min(Math.Min(fraction * Acoustic, Speed), Math.Min(Viscosity, Walls)), Math.Min(Weight, SurfaceTension));

        /// <summary>What limits the step and what would lengthen it, as a sentence.</summary>
        /// <param name="timeStep">The step in use [s].</param>
        /// <returns>The sentence, with figures.</returns>
        public string Explain(double timeStep) => double.IsInfinity(Largest)
            ? $"Nothing limits the time step of {Milliseconds(timeStep)}."
            : FormattableString.Invariant($"The time step of {Milliseconds(timeStep)} is {100.0 * timeStep / Largest:0} % of the ") +
                FormattableString.Invariant($"largest stable one, {Milliseconds(Largest)}, which {Cause}; {Cure}.{Implicit}");

        private string Implicit => ViscosityIsImplicit && Limit != TimeStepLimit.Viscosity
            ? FormattableString.Invariant($" The kinematic viscosity ({KinematicViscosity:G3} m²/s) is implicit and sets no limit.")
            : "";

        /// <summary>"the speed of sound (12.5 m/s) sets".</summary>
        internal string Cause
        {
            get
            {
                switch (Limit)
                {
                    case TimeStepLimit.Acoustic:
                        return FormattableString.Invariant($"the speed of sound ({SoundSpeed:G3} m/s, liquid at {MaxSpeed:G3} m/s) sets");
                    case TimeStepLimit.Speed:
                        return FormattableString.Invariant($"the fastest particle ({MaxSpeed:G3} m/s) sets at {SpeedLimit} spacings a ") +
                            "step";
                    case TimeStepLimit.Viscosity:
                        return FormattableString.Invariant($"the kinematic viscosity ({KinematicViscosity:G3} m²/s) sets");
                    case TimeStepLimit.SurfaceTension:
                        return "the surface tension sets";
                    case TimeStepLimit.Weight:
                        return "the liquid's weight sets, which its iterations do not carry in longer ones";
                    default:
                        return "the stiffness of the walls sets";
                }
            }
        }

        /// <summary>"half the viscosity … would allow 1.2 ms".</summary>
        internal string Cure
        {
            get
            {
                switch (Limit)
                {
                    case TimeStepLimit.Acoustic:
                        double slower = Acoustic * (SoundSpeed + MaxSpeed) / (0.5 * SoundSpeed + MaxSpeed);
                        return $"half of it, by Sound Speed Ratio or in deep liquid Max Compression, would allow {Allowed(slower)} at " +
                            "four times the compression";
                    case TimeStepLimit.Speed:
                        return $"twice the Particle Spacing would allow {Allowed(2.0 * Speed)}";
                    case TimeStepLimit.Viscosity:
                        return $"half of it, by Kinematic Viscosity or Viscosity Ratio, would allow {Allowed(2.0 * Viscosity)}";
                    case TimeStepLimit.Weight:
                        return $"twice the Particle Spacing would allow {Allowed(2.0 * Weight)}, and more Substeps make shorter ones";
                    case TimeStepLimit.SurfaceTension:
                        return $"a quarter of the Surface Tension would allow {Allowed(2.0 * SurfaceTension)}";
                    default:
                        return $"a quarter of the Wall Stiffness Ratio would allow {Allowed(2.0 * Walls)}";
                }
            }
        }

        // 0.88 ms; 1.5 s.
        internal static string Milliseconds(double seconds) => seconds < 1.0
            ? FormattableString.Invariant($"{1e3 * seconds:G3} ms")
            : FormattableString.Invariant($"{seconds:G3} s");

        private string Allowed(double changed)
        {
            TimeStepLimit limit = Limit;
            double others = double.PositiveInfinity;
            if (limit != TimeStepLimit.Acoustic) others = Math.Min(others, Acoustic);
            if (limit != TimeStepLimit.Speed) others = Math.Min(others, Speed);
            if (limit != TimeStepLimit.Viscosity) others = Math.Min(others, Viscosity);
            if (limit != TimeStepLimit.Walls) others = Math.Min(others, Walls);
            if (limit != TimeStepLimit.Weight) others = Math.Min(others, Weight);
            if (limit != TimeStepLimit.SurfaceTension) others = Math.Min(others, SurfaceTension);
            return Milliseconds(Math.Min(changed, others));
        }
    }
}
