using System;
using System.Collections.Generic;

namespace SphFluid.Editor
{
    /// <summary>The constants that the rules chose and the advice on the time step, as the inspector shows them.</summary>
    public readonly struct TimeStepText
    {
        private TimeStepText(List<(string, string)> lines, string advice)
        {
            Lines = lines;
            Advice = advice;
        }

        /// <summary>Labels and values.</summary>
        public IReadOnlyList<(string Label, string Value)> Lines { get; }

        /// <summary>The advice as a sentence.</summary>
        public string Advice { get; }

        /// <summary>Of a simulation that would start with these constants, at the fastest speed that they are made for.</summary>
        /// <param name="simulation">The simulation, with a profile.</param>
        /// <param name="constants">Its constants.</param>
        /// <returns>The text.</returns>
        public static TimeStepText Before(FluidSimulation simulation, in FluidSolverSettings constants)
        {
            return Create(constants, constants.MaxSpeed, StepOf(simulation, constants));
        }

        /// <summary>
        /// The time step of a simulation that would start with these constants, at the fastest speed that they are made for [s].
        /// </summary>
        internal static double StepOf(FluidSimulation simulation, in FluidSolverSettings constants) =>
            simulation.TimeStepMode == FluidTimeStepMode.Adaptive && !FluidMethods.Has(constants.Method, FluidMethodFeatures.StepsByFrame)
            ? FluidRules.Advise(constants, constants.MaxSpeed).Step(simulation.Profile.TimeStepFraction)
            : constants.TimeStep;

        /// <summary>Of a running simulation at its measured speed.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>The text.</returns>
        public static TimeStepText Now(FluidSimulation simulation)
        {
            float speed = simulation.Solver.Counters.MaxSpeed;
            return Create(simulation.Solver.Settings, speed < float.PositiveInfinity ? speed : float.MaxValue, simulation.TimeStep);
        }

        private static TimeStepText Create(in FluidSolverSettings settings, float speed, double step)
        {
            TimeStepAdvice advice = FluidRules.Advise(settings, speed);
            var lines = new List<(string, string)>
            {
                ("Speed of sound c", FormattableString.Invariant($"{settings.SoundSpeed:G4} m/s")),
                ("Compression allowed", FormattableString.Invariant($"{100.0 * Compression(settings):G2} % at {settings.MaxSpeed:G3} m/s")),
                ("Viscosity ν", FormattableString.Invariant($"{settings.Viscosity / settings.RestDensity:G3} m²/s")),
                ("Time step", TimeStepAdvice.Milliseconds(step)),
            };
            if (!double.IsInfinity(advice.Largest))
            {
                lines
                    .Add(
                        ("Largest stable step",
                            FormattableString.Invariant($"{TimeStepAdvice.Milliseconds(advice.Largest)} at {speed:G3} m/s")));
                lines.Add(("Limited by", TimeStepAdvice.NameOf(advice.Limit)));
                lines.Add(("Share in use", FormattableString.Invariant($"{100.0 * step / advice.Largest:0} %")));
            }
            lines.AddRange(FluidMethods.Get(settings.Method).Remarks(settings, step, speed));
            return new TimeStepText(lines, advice.Explain(step));
        }

        // (v/c)²: what motion at the expected speed compresses. The liquid's weight adds its own g D/c².
        private static double Compression(in FluidSolverSettings settings)
        {
            double mach = settings.MaxSpeed / (double)settings.SoundSpeed;
            return mach * mach;
        }
    }
}
