using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Constants of a run: speed of sound and time step from the case's own speed and what the chart sweeps.</summary>
    public static class CaseSettings
    {
        /// <summary>Constants of a run.</summary>
        /// <param name="parameters">What the chart sweeps.</param>
        /// <param name="domainSize">Domain box [m].</param>
        /// <param name="spacing">dx [m].</param>
        /// <param name="speed">The case's own speed U [m/s]: c = ratio · U exactly.</param>
        /// <param name="gravity">Gravity [m/s²].</param>
        /// <param name="viscosity">ν [m²/s] exactly; null: water's, or the least that the method needs.</param>
        /// <param name="boundaries">Periodic axes and walls.</param>
        /// <exception cref="System.ArgumentException">They cannot be computed with, for instance a periodic axis too short for κ.</exception>
        public static FluidSolverSettings For(in CaseParameters parameters, Vector3 domainSize, double spacing, double speed,
            Vector3 gravity, double? viscosity = null, in FluidBoundaries boundaries = default)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = parameters.Method.Kind;
            input.DomainSize = domainSize;
            input.Spacing = (float)spacing;
            input.Gravity = gravity;
            input.LiquidHeight = 0f;
            input.LiquidDepth = 0f;
            input.InitialSpeed = 0f;
            input.MinSpeed = (float)speed;
            input.MaxCompression = 1f;
            input.SupportRatio = (float)parameters.SupportRatio;
            input.SoundSpeedRatio = (float)parameters.SoundSpeedRatio;
            input.TimeStepFraction = (float)parameters.TimeStepFraction;
            if (viscosity.HasValue)
            {
                input.KinematicViscosity = (float)viscosity.Value;
                input.ViscosityRatio = 0f;
            }
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.OctantSearch = false; // the same pairs, faster
            if (parameters.Method.Kind == FluidMethodKind.ThesisPrinted)
                settings = settings.With(ThesisSwitches.Printed);
            settings.Boundaries = boundaries;
            settings.Validate();
            return settings;
        }
    }
}
