using System;

namespace SphFluid
{
    /// <summary>
    /// Watches for a liquid that is driven harder than its constants are made for: by colliders, which is known at once, or by whatever
    /// else keeps it compressed. Names the Expected Speed that does.
    /// </summary>
    internal sealed class SoftnessWatch
    {
        // s: a knock and a splash are over by then.
        private const double LastingTime = 0.1;

        // Over the speed that the constants are made for; ForceZones allow the same.
        private const double MostDriven = 1.25;

        // Of the mean compression over that of the deepest liquid at rest; a splash that falls back reaches 1.1.
        private const double MostPressed = 3.0;

        // What was said holds until so much more is needed.
        private const double Again = 2.0;

        private double driven, drivenTime, drivenSaid, pressed, pressedTime;
        private bool pressedSaid;

        /// <summary>Takes note of a frame.</summary>
        /// <returns>What to report; null when nothing new.</returns>
        public FluidMessage? Update(in FluidSpec spec, FluidStart start, FluidPace pace, in FluidSolverSettings settings,
            ColliderLoads loads, double time)
        {
            Watch(!pace.FollowsColliders && pace.Driven > MostDriven * settings.MaxSpeed, pace.Driven, time, ref driven, ref drivenTime);
            Watch(FluidMethods.Has(spec.Method, FluidMethodFeatures.FollowingSoundSpeed) &&
                pace.Compression > MostPressed * pace.PressedByRule, pace.Compression, time, ref pressed, ref pressedTime);
            if (drivenTime >= LastingTime && driven > Again * drivenSaid)
            {
                drivenSaid = driven;
                return Message(spec,
                    FormattableString.Invariant($"'{loads.Name}' drives the liquid to {driven:0.##} m/s, and its speed of sound is made ") +
                    FormattableString.Invariant($"for {settings.MaxSpeed:0.##} m/s: it is compressed more than it should be."),
                    FluidMethods.Has(spec.Method, FluidMethodFeatures.StepsByFrame) ? "Set Time Step Mode to Automatic"
                        : FluidConstants.ExpectedSpeedCure(spec, start, MostDriven * driven), ".");
            }
            if (pressedSaid || drivenSaid > 0.0 || pressedTime < LastingTime) return null;
            pressedSaid = true;
            return Message(spec,
                FormattableString.Invariant($"The liquid is compressed by {100.0 * pressed:0} % in the mean, by more than its fall and ") +
                "its weight: its speed of sound is too low for what presses it.",
                FluidConstants.ExpectedSpeedCure(spec, start, MostDriven * Math.Sqrt(pressed / pace.PressedByRule) * settings.MaxSpeed),
                "; where colliders close on it, leave it the room that it fills.");
        }

        private static void Watch(bool now, double value, double time, ref double worst, ref double lasting)
        {
            worst = now ? Math.Max(worst, value) : 0.0;
            lasting = now ? lasting + time : 0.0;
        }

        private static FluidMessage Message(in FluidSpec spec, string text, string cure, string end) =>
            new FluidMessage(FluidSeverity.Warning, FluidIssue.LiquidTooSoft, spec.Owner, text, cure + end);
    }
}
