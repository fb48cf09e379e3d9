using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Constants of a run: speed of sound and time step from the case's own speed and what the chart sweeps.</summary>
    public static class CaseSettings
    {
        /// <summary>Steps of the Standard method that a substep of the method Robust takes as long as.</summary>
        public const double StandardStepsPerSubstep = 3.0;

        /// <summary>Constants of a run.</summary>
        /// <param name="parameters">What the chart sweeps.</param>
        /// <param name="domainSize">Domain box [m].</param>
        /// <param name="spacing">dx [m].</param>
        /// <param name="speed">The case's own speed U [m/s]: c = ratio · U exactly.</param>
        /// <param name="gravity">Gravity [m/s²].</param>
        /// <param name="viscosity">ν [m²/s] exactly, in steps as short as that takes; null: water's, or the least that the method
        /// needs.</param>
        /// <param name="boundaries">Periodic axes and walls.</param>
        /// <param name="tension">Surface tension σ [N/m], for methods that have it.</param>
        /// <exception cref="ArgumentException">They cannot be computed with, for instance a periodic axis too short for κ.</exception>
        public static FluidSolverSettings For(in CaseParameters parameters, Vector3 domainSize, double spacing, double speed,
            Vector3 gravity, double? viscosity = null, in FluidBoundaries boundaries = default, double tension = 0.0)
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
            input.SurfaceTension = (float)tension;
            input.TensionAtAnySpacing = true;
            input.GradientCorrection = parameters.Method.CorrectsGradient;
            if (viscosity.HasValue)
            {
                input.KinematicViscosity = (float)viscosity.Value;
                input.ViscosityRatio = 0f;
            }
            if (parameters.Method.Kind == FluidMethodKind.Robust) input = WithSubsteps(input, speed);
            FluidSolverSettings settings = FluidRules.Derive(input);
            if (viscosity > 0.0)
            {
                settings.TimeStep =
                    (float)(settings.TimeStep * Math.Min(1.0, FluidRules.ActingViscosity(settings, settings.TimeStep) / viscosity.Value));
            }
            settings.OctantSearch = false; // the same pairs, faster
            if (parameters.Method.Kind == FluidMethodKind.ThesisPrinted) settings = settings.With(ThesisSwitches.Printed);
            settings.Boundaries = boundaries;
            settings.Validate();
            return settings;
        }

        /// <summary>Speed of sound that the liquid has in its steps [m/s].</summary>
        internal static double EffectiveSoundSpeed(in FluidSolverSettings settings) =>
            FluidRules.EffectiveSoundSpeed(settings, settings.TimeStep, settings.MaxSpeed);

        // A frame of the method Robust is its four substeps, and twelve steps of the Standard method at the same fraction and speed of
        // sound: at 60 frames a second that is a frame of liquid at 4 m/s and dx = 2 cm. Its iterations carry liquid of the depth of which
        // U is √(g D).
        private static FluidRuleInput WithSubsteps(FluidRuleInput input, double speed)
        {
            FluidRuleInput standard = input;
            standard.Method = FluidMethodKind.Standard;
            input.FixedTimeStep = (float)(StandardStepsPerSubstep * FluidRules.Derive(standard).TimeStep);
            double gravity = input.Gravity.magnitude;
            input.LiquidDepth = gravity > 0.0 ? (float)(speed * speed / gravity) : 0f;
            return input;
        }
    }
}
