using static System.FormattableString;

namespace SphFluid
{
    /// <summary>Detectors of steps that are too long and of what they end in.</summary>
    internal static class StabilityDetectors
    {
        // Disorder moves the border of the lattice: a liquid whose energy grows this near to it has too long a step.
        private const double NearBorder = 0.8;

        private const double Rounding = 1e-3;

        public static FluidFinding? NonFinite(FluidEvidence e)
        {
            long count = e.Now.NonFinite + e.NewNonFinite;
            if (count == 0) return null;
            return new FluidFinding(FluidFailure.NonFinite, count, 0.0,
                Invariant($"{count} positions, velocities or densities are not finite numbers."),
                e.ShorterSteps + ", and raise Expected Speed if colliders or forces move the liquid faster than its fall.");
        }

        public static FluidFinding? EnergyGrowth(FluidEvidence e)
        {
            if (!e.EnergyGrows) return null;
            double now = e.AvailableEnergy(e.Now), first = e.AvailableEnergy(e.First);
            return new FluidFinding(FluidFailure.EnergyGrowth, now, e.EnergyLimit,
                Invariant($"The liquid's energy has grown from {first:G3} J to {now:G3} J since {e.First.Time:0.###} s, and nothing ") +
                "gave it any.",
                e.ShorterSteps + ", or raise the Viscosity Ratio.");
        }

        public static FluidFinding? TimeStepTooLong(FluidEvidence e)
        {
            double border = e.Advice.Acoustic;
            if (!(e.TimeStep > border || (e.EnergyGrows && e.TimeStep > NearBorder * border))) return null;
            return new FluidFinding(FluidFailure.TimeStepTooLong, e.TimeStep, border,
                Invariant($"The time step of {1e3 * e.TimeStep:G3} ms is {100.0 * e.TimeStep / border:0} % of the border of stability, ") +
                Invariant($"{1e3 * border:G3} ms, ") +
                Invariant($"that the speed of sound ({e.Advice.SoundSpeed:G3} m/s) sets on a regular lattice."),
                e.ShorterSteps + ", or the Sound Speed Ratio.");
        }

        public static FluidFinding? ViscosityTooStiff(FluidEvidence e)
        {
            if (!(e.Advice.KinematicViscosity > 0.0)) return null;
            double border = e.Advice.ViscosityBorder;
            if (!(e.TimeStep > border || (e.EnergyGrows && e.TimeStep > NearBorder * border))) return null;
            return new FluidFinding(FluidFailure.ViscosityTooStiff, e.TimeStep, border,
                Invariant($"The time step of {1e3 * e.TimeStep:G3} ms is {100.0 * e.TimeStep / border:0} % of the border of stability, ") +
                Invariant($"{1e3 * border:G3} ms, ") +
                Invariant($"that the kinematic viscosity ({e.Advice.KinematicViscosity:G3} m²/s) sets."),
                "Use Time Step Mode Automatic, or lower the profile's Kinematic Viscosity or Viscosity Ratio.");
        }

        public static FluidFinding? Tunnelling(FluidEvidence e)
        {
            // its steps are made for that; what contact does not follow the guards report
            if (e.Has(FluidMethodFeatures.StepsByFrame)) return null;
            double displacement = e.Now.MaxSpeed * e.TimeStep / e.Settings.Spacing;
            if (!(displacement > TimeStepAdvice.SpeedLimit * (1.0 + Rounding))) return null;
            return new FluidFinding(FluidFailure.Tunnelling, displacement, TimeStepAdvice.SpeedLimit,
                Invariant($"The fastest particle, at {e.Now.MaxSpeed:G3} m/s, moves {displacement:0.00} spacings a step: ") +
                (e.Has(FluidMethodFeatures.PenaltyWalls) ? "it can cross a thin wall before the wall pushes."
                    : "colliders hold it, but it runs into other liquid before pressure acts."),
                e.ShorterSteps + Invariant($", raise Expected Speed to {e.Now.MaxSpeed:G3} m/s or set Time Step Mode to Adaptive") +
                (e.Has(FluidMethodFeatures.PenaltyWalls) ? "; make thin colliders thicker than a spacing." : "."));
        }

        public static FluidFinding? ClampActs(FluidEvidence e)
        {
            if (e.NewClampHits <= 0) return null;
            return new FluidFinding(FluidFailure.ClampActs, e.NewClampHits, 0.0,
                Invariant($"The limit on accelerations cut {e.NewClampHits} of them since the last measurement: each one loses momentum."),
                e.ShorterSteps + " or raise Expected Speed; a Thesis Switches > Acceleration Limit As Printed always acts.");
        }
    }
}
