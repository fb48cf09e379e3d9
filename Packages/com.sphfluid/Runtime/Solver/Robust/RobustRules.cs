using System;

namespace SphFluid
{
    /// <summary>
    /// Constants of the Robust method by rule: those of <see cref="CellRules"/>, and
    /// <list type="bullet">
    /// <item><description>dt: a frame over its substeps, whatever the speed.</description></item>
    /// <item><description>n: 2 iterations; 4 where the fastest particle goes farther than 1.7 dx in a step, 8 beyond 3 dx; as many as carry
    /// the liquid's weight, 16 at most.</description></item>
    /// <item><description>ω: 0.35 up to κ = 2.25, 0.25 at 2.5, less beyond.</description></item>
    /// <item><description>c_eff = A dx √(n ω)/dt: n iterations are a spring. 1/c_tot² = 1/(c² (1 − (1 − ω)ⁿ)) +
    /// 1/c_eff².</description></item>
    /// </list>
    /// </summary>
    internal static class RobustRules
    {
        /// <summary>Frame that the time step is made for until one is known [s].</summary>
        public const double NominalFrame = 1.0 / 60.0;

        /// <summary>Longest frame that is cut into no more than the substeps that were asked for [s].</summary>
        public const double LongestFrame = 1.0 / 30.0;

        /// <summary>Least iterations of a step.</summary>
        public const int LeastIterations = 2;

        /// <summary>Most iterations of a step that the rule takes for the liquid's weight.</summary>
        public const int MostForWeight = 16;

        // c_eff/√(g D) that iterations are taken for; liquid of less than 1.2 sinks in by its own weight, by half of its depth, or bursts.
        private const double CarryingRatio = 2.0;
        private const double CollapseRatio = 1.5;

        // c_eff/v_max of liquid far from cameras: at 1.7 a dam is compressed by 30 % where it hits, at 1.1 by 67 %.
        private const double LeastRatio = 1.5;

        // Of the lattice's stiffness: what settled liquid, which is no lattice, has of it. From columns; robust.md.
        private const double Disorder = 0.88;

        // Of the profile's Viscosity Ratio, as Standard has it.
        private const double ViscosityShare = 0.1;

        // Of R² M/dt: explicit viscosity keeps half of its border of 0.072.
        private const double ViscousLimit = 0.035;

        // Iterations of a step that hardly compresses.
        private const int MostWithoutCrowds = 4;

        public static FluidSolverSettings Derive(in FluidRuleInput input)
        {
            FluidSolverSettings settings = CellRules.Derive(input, ViscosityShare, out _, out double sound, out _);
            settings.TimeStep = input.FixedTimeStep > 0f ? input.FixedTimeStep : (float)(NominalFrame / input.Substeps);
            return settings.WithOwn(new RobustSettings
            {
                SoundSpeed = (float)sound,
                Substeps = input.Substeps,
                Iterations = LeastIterations,
                Relaxation = (float)RelaxationFor(input.SupportRatio),
                DepthSpeed = (float)Math.Sqrt(input.Gravity.magnitude * input.LiquidDepth + 0.5 * input.LoadSpeed * input.LoadSpeed),
                StableOrder = true,
                NeighbourList = true,
            });
        }

        /// <summary>Substeps that a liquid is cut into where it may take steps some times longer.</summary>
        public static int CoarserSubsteps(int substeps, double factor) => Math.Max(1, (int)Math.Ceiling(substeps / factor - 1e-6));

        /// <summary>
        /// The same as far as it pays: deep liquid needs the more iterations the longer a step is. Worked example: 4 substeps of 2
        /// iterations, as 8 passes, become 2 of 3, as 6.
        /// </summary>
        public static int FewestSubsteps(in FluidRuleInput input, double asked)
        {
            int best = input.Substeps, least = CoarserSubsteps(input.Substeps, asked);
            FluidSolverSettings settings = Derive(input);
            int Iterations(int substeps) => substeps * IterationsFor(settings, NominalFrame / substeps, settings.MaxSpeed);
            double weight = CarryingRatio * settings.Own<RobustSettings>().DepthSpeed;
            double longest = Math.Min(IterationSpeed(settings, 1.0, MostForWeight) / weight,
                IterationSpeed(settings, 1.0, LeastIterations) / (LeastRatio * settings.MaxSpeed));
            for (int substeps = best - 1; substeps >= least && NominalFrame / substeps <= longest; substeps--)
                if (Iterations(substeps) < Iterations(best)) best = substeps;
            return best;
        }

        /// <summary>ω by κ: two fifths to a half of the border of the lattice, as compression adds neighbours.</summary>
        public static double RelaxationFor(double supportRatio) =>
            supportRatio <= 2.25 ? 0.35 : supportRatio <= 2.5 ? 0.35 - 0.4 * (supportRatio - 2.25)
                : 0.25 * Math.Pow(2.5 / supportRatio, 3.0);

        /// <summary>Iterations of a step.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="speed">Its fastest speed [m/s].</param>
        public static int IterationsFor(in FluidSolverSettings settings, double timeStep, double speed)
        {
            RobustSettings own = settings.Own<RobustSettings>();
            double spacings = speed * timeStep / settings.Spacing;
            int forSpeed = spacings > 3.0 ? 8 : spacings > 1.7 ? 4 : 1;
            double forWeight = Math.Pow(CarryingRatio * own.DepthSpeed / IterationSpeed(settings, timeStep, 1), 2.0);
            return Math.Max(own.Iterations, Math.Max(forSpeed, (int)Math.Ceiling(Math.Min(forWeight, MostForWeight) - 1e-6)));
        }

        /// <summary>c_eff of iterations alone [m/s].</summary>
        public static double IterationSpeed(in FluidSolverSettings settings, double timeStep, int iterations)
        {
            double ratio = settings.SupportRadius / settings.Spacing;
            double stiffness = Disorder * Math.Sqrt(WendlandKernel.LatticeMoment(ratio) / WendlandKernel.LatticeSquares(ratio));
            return stiffness * settings.Spacing * Math.Sqrt(iterations * settings.Own<RobustSettings>().Relaxation) / timeStep;
        }

        /// <summary>The speed of sound that a liquid has, c_tot [m/s].</summary>
        public static double EffectiveSoundSpeed(in FluidSolverSettings settings, double timeStep, int iterations)
        {
            RobustSettings own = settings.Own<RobustSettings>();
            double reached = Reached(own, iterations), spring = IterationSpeed(settings, timeStep, iterations);
            return 1.0 / Math.Sqrt(1.0 / (reached * own.SoundSpeed * (double)own.SoundSpeed) + 1.0 / (spring * spring));
        }

        /// <summary>
        /// α of a step: 1/(c² dt²), or as much more as makes the liquid as soft as it was in the longest step of late. Steps that vary
        /// would else make its stiffness vary as 1/dt², and liquid at rest jump up and down by parts of its compression.
        /// </summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="longest">The longest step of late, no less [s].</param>
        /// <param name="iterations">Iterations of the step.</param>
        /// <returns>α [1/m²].</returns>
        public static double Compliance(in FluidSolverSettings settings, double timeStep, double longest, int iterations)
        {
            RobustSettings own = settings.Own<RobustSettings>();
            double softness = 1.0 / ((double)own.SoundSpeed * own.SoundSpeed);
            if (longest > timeStep)
            {
                double before = IterationSpeed(settings, longest, iterations), now = IterationSpeed(settings, timeStep, iterations);
                softness += Reached(own, iterations) * (1.0 / (before * before) - 1.0 / (now * now));
            }
            return softness / (timeStep * timeStep);
        }

        // What of a compliance some iterations make act.
        private static double Reached(in RobustSettings own, int iterations) => 1.0 - Math.Pow(1.0 - own.Relaxation, iterations);

        /// <summary>
        /// The dynamic viscosity that acts, which a long step bounds [Pa s]. What takes many iterations is compressed where it hits
        /// something: the border of the lattice falls with the number of its neighbours.
        /// </summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="iterations">Its iterations.</param>
        public static double ActingViscosity(in FluidSolverSettings settings, double timeStep, int iterations)
        {
            double radius = settings.SupportRadius, moment = WendlandKernel.LatticeMoment(radius / settings.Spacing);
            double limit = ViscousLimit * Math.Min(1.0, MostWithoutCrowds / (double)iterations);
            return Math.Min(settings.Viscosity, limit * moment * radius * radius / timeStep * settings.RestDensity);
        }

        /// <summary>Advice for a running liquid: no speed and no stiffness limits the step, only its own weight does.</summary>
        public static TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed)
        {
            RobustSettings own = settings.Own<RobustSettings>();
            double weight = own.DepthSpeed > 0f
                ? IterationSpeed(settings, 1.0, Math.Max(own.Iterations, MostForWeight)) / (CollapseRatio * own.DepthSpeed)
                : double.PositiveInfinity;
            return new TimeStepAdvice(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity,
                double.PositiveInfinity,
                own.SoundSpeed, maxSpeed, settings.Viscosity / settings.RestDensity, weight: weight);
        }
    }
}
