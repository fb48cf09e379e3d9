using System;

namespace SphFluid
{
    /// <summary>What limits a time step.</summary>
    public enum TimeStepLimit
    {
        /// <summary>Pressure waves: dt ≤ C R / (c + v).</summary>
        Acoustic,
        /// <summary>The way of a particle: v dt ≤ 0.4 dx.</summary>
        Speed,
        /// <summary>Explicit viscosity: ν dt ≤ C R².</summary>
        Viscosity,
        /// <summary>The penalty walls' spring: k_w dt² ≤ 4 − 2 c_w dt.</summary>
        Walls,
    }

    /// <summary>
    /// The largest stable time step of a liquid and what limits it. The acoustic limit is the border itself, of which a step is a
    /// fraction; the others are kept with a margin.
    /// </summary>
    public readonly struct TimeStepAdvice
    {
        /// <summary>dt √k/R at the border of stability: Müller's force on a cubic lattice by leapfrog, for κ = 2 to 4; k = 2 c².</summary>
        public const double AcousticBorder = 1.35;

        /// <summary>ν dt/R² at the border of stability: Müller's viscosity on a cubic lattice, for κ = 1.7 and more.</summary>
        public const double ViscousBorder = 0.115;

        /// <summary>ν dt/R² that is advised, about half of the border.</summary>
        public const double ViscousLimit = 0.06;

        /// <summary>Way of a particle in a step over the spacing that is advised: it meets each wall before it is through.</summary>
        public const double SpeedLimit = 0.4;

        // Penalty wall: k_w dt² < 4 − 2 c_w dt, kept with a tenth to spare.
        const double WallMargin = 0.9;

        /// <summary>Largest stable step by each limit [s]; infinite where it does not act.</summary>
        public readonly double Acoustic, Speed, Viscosity, Walls;

        /// <summary>What the limits are of: effective speed of sound and fastest speed [m/s], kinematic viscosity [m²/s].</summary>
        public readonly double SoundSpeed, MaxSpeed, KinematicViscosity;

        // Wendland's C2 for density and force: the lattice's borders are 0.86 to 0.93 R M/c and 0.072 R² M/ν (von Neumann), M the lattice's moment.
        const double OneKernelAcousticBorder = 0.9;
        const double OneKernelViscousLimit = 0.035;

        TimeStepAdvice(double acoustic, double speedLimit, double viscous, double sound, double speed, double kinematic)
        {
            Acoustic = acoustic;
            Speed = speedLimit;
            Viscosity = viscous;
            Walls = double.PositiveInfinity;
            SoundSpeed = sound;
            MaxSpeed = speed;
            KinematicViscosity = kinematic;
        }

        TimeStepAdvice(double spacing, double radius, double sound, double speed, double kinematic, double wallStiffness, double wallDamping)
        {
            // With c and v: the waves that two parts of the liquid send each other run at c on top of their own speed.
            Acoustic = AcousticBorder * radius / (Math.Sqrt(2.0 * sound * sound) * (1.0 + speed / sound));
            Speed = speed > 0.0 ? SpeedLimit * spacing / speed : double.PositiveInfinity;
            Viscosity = kinematic > 0.0 ? ViscousLimit * radius * radius / kinematic : double.PositiveInfinity;
            Walls = WallStep(wallStiffness, wallDamping);
            SoundSpeed = sound;
            MaxSpeed = speed;
            KinematicViscosity = kinematic;
        }

        /// <summary>Advice for a liquid.</summary>
        /// <param name="settings">Its constants.</param>
        /// <param name="maxSpeed">Its fastest speed now [m/s].</param>
        /// <returns>The limits.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The speed is negative or not finite.</exception>
        public static TimeStepAdvice For(in FluidSolverSettings settings, double maxSpeed)
        {
            if (!(maxSpeed >= 0.0) || double.IsInfinity(maxSpeed))
            {
                throw new ArgumentOutOfRangeException(nameof(maxSpeed), maxSpeed, "The fastest speed must be zero or more, and finite.");
            }

            if (settings.Method == FluidMethodKind.Standard)
            {
                return OfOneKernel(settings.Spacing, settings.SupportRadius, settings.SoundSpeed, maxSpeed, settings.Viscosity / settings.RestDensity);
            }

            // 6.3.3 as printed multiplies the force density by m where the equation divides by ρ: m ρ times the acceleration.
            double factor = settings.ForceTimesMass ? (double)settings.ParticleMass * settings.RestDensity : 1.0;
            return Of(settings.Spacing, settings.SupportRadius, settings.SoundSpeed * Math.Sqrt(factor), maxSpeed,
                factor * settings.Viscosity / settings.RestDensity, settings.WallStiffness, settings.WallDamping);
        }

        /// <summary>Advice from bare numbers, in double precision, for the rules.</summary>
        internal static TimeStepAdvice Of(double spacing, double radius, double sound, double speed, double kinematic,
            double wallStiffness, double wallDamping) =>
            new TimeStepAdvice(spacing, radius, sound, speed, kinematic, wallStiffness, wallDamping);

        /// <summary>Advice for the Standard method, whose walls set no limit of their own. Its forces are over <see cref="WendlandKernel.LatticeMoment"/>.</summary>
        internal static TimeStepAdvice OfOneKernel(double spacing, double radius, double sound, double speed, double kinematic)
        {
            double moment = WendlandKernel.LatticeMoment(radius / spacing);
            return new TimeStepAdvice(
                OneKernelAcousticBorder * radius / (sound / moment + speed),
                speed > 0.0 ? SpeedLimit * spacing / speed : double.PositiveInfinity,
                kinematic > 0.0 ? OneKernelViscousLimit * moment * radius * radius / kinematic : double.PositiveInfinity,
                sound, speed, kinematic);
        }

        /// <summary>The smallest of the limits [s].</summary>
        public double Largest => Math.Min(Math.Min(Acoustic, Speed), Math.Min(Viscosity, Walls));

        /// <summary>The limit that is the smallest.</summary>
        public TimeStepLimit Limit
        {
            get
            {
                double largest = Largest;
                return largest == Acoustic ? TimeStepLimit.Acoustic
                    : largest == Speed ? TimeStepLimit.Speed
                    : largest == Viscosity ? TimeStepLimit.Viscosity
                    : TimeStepLimit.Walls;
            }
        }

        /// <summary>The step to take: a fraction of the acoustic limit, and no more than the others, which have their margin.</summary>
        /// <param name="fraction">Of the acoustic limit; 0.6 by default in a profile.</param>
        /// <returns>Its length [s].</returns>
        public double Step(double fraction) => Math.Min(fraction * Acoustic, Math.Min(Speed, Math.Min(Viscosity, Walls)));

        /// <summary>What limits the step and what would lengthen it, as a sentence.</summary>
        /// <param name="timeStep">The step in use [s].</param>
        /// <returns>The sentence, with figures.</returns>
        public string Explain(double timeStep) => FormattableString.Invariant(
            $"The time step of {Milliseconds(timeStep)} is {100.0 * timeStep / Largest:0} % of the largest stable one, {Milliseconds(Largest)}, which {Cause}; {Cure}.");

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
                        return FormattableString.Invariant($"the fastest particle ({MaxSpeed:G3} m/s) sets at {SpeedLimit} spacings a step");
                    case TimeStepLimit.Viscosity:
                        return FormattableString.Invariant($"the kinematic viscosity ({KinematicViscosity:G3} m²/s) sets");
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
                        return $"half of it, by Sound Speed Ratio or in deep liquid Max Compression, would allow {Allowed(slower)} at four times the compression";
                    case TimeStepLimit.Speed:
                        return $"twice the Particle Spacing would allow {Allowed(2.0 * Speed)}";
                    case TimeStepLimit.Viscosity:
                        return $"half of it, by Kinematic Viscosity or Viscosity Ratio, would allow {Allowed(2.0 * Viscosity)}";
                    default:
                        return $"a quarter of the Wall Stiffness Ratio would allow {Allowed(2.0 * Walls)}";
                }
            }
        }

        // 0.88 ms; 1.5 s.
        internal static string Milliseconds(double seconds) => seconds < 1.0
            ? FormattableString.Invariant($"{1e3 * seconds:G3} ms")
            : FormattableString.Invariant($"{seconds:G3} s");

        string Allowed(double changed)
        {
            TimeStepLimit limit = Limit;
            double others = double.PositiveInfinity;
            if (limit != TimeStepLimit.Acoustic) others = Math.Min(others, Acoustic);
            if (limit != TimeStepLimit.Speed) others = Math.Min(others, Speed);
            if (limit != TimeStepLimit.Viscosity) others = Math.Min(others, Viscosity);
            if (limit != TimeStepLimit.Walls) others = Math.Min(others, Walls);
            return Milliseconds(Math.Min(changed, others));
        }

        // Largest dt with k dt² = margin (4 − 2 c dt).
        static double WallStep(double stiffness, double damping)
        {
            if (stiffness <= 0.0)
            {
                return double.PositiveInfinity;
            }

            double half = WallMargin * damping;
            return (Math.Sqrt(half * half + 4.0 * WallMargin * stiffness) - half) / stiffness;
        }
    }
}
