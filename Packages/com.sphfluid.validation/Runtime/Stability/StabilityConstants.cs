using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Constants of a cell, each set directly: speed of sound, viscosity and time step are the axes of the maps and follow no rule.
    /// c is the nominal speed of sound, √k, as the linear theory has it: with the ½ of the thesis's equation (13) waves run at √(k/2).
    /// </summary>
    internal struct StabilityConstants
    {
        /// <summary>Particle spacing of all scenes [m].</summary>
        public const double Spacing = 0.1;

        public CaseMethod Method;
        public Vector3 DomainSize;

        /// <summary>κ = R/dx.</summary>
        public double Support;

        /// <summary>c = √k [m/s].</summary>
        public double Sound;

        /// <summary>ν [m²/s]; not a number: that of the package's rules.</summary>
        public double Viscosity;

        /// <summary>dt [s].</summary>
        public double TimeStep;

        /// <summary>Speed that walls are made for [m/s].</summary>
        public double Speed;

        public Vector3 Gravity;
        public FluidAxes Periodic;

        /// <summary>Whether the emergency limit on accelerations acts, where the method has one.</summary>
        public bool Clamps;

        /// <summary>Whether negative pressures may act: a box full of liquid has no surface that they could tear.</summary>
        public bool Suction;

        public FluidSolverSettings Settings()
        {
            StabilityTheory theory = StabilityTheory.Of(Method);
            bool isThesis = theory == StabilityTheory.Thesis;
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = isThesis ? FluidMethodKind.Thesis : Method.Kind;
            input.GradientCorrection = Method.CorrectsGradient;
            input.DomainSize = DomainSize;
            input.Spacing = (float)Spacing;
            input.Gravity = Gravity;
            input.SupportRatio = (float)Support;
            input.MinSpeed = (float)Speed;
            input.MaxCompression = 1f;
            input.SoundSpeedRatio = (float)(Sound * theory.WaveSpeedRatio / Speed);
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.TimeStep = (float)TimeStep;
            if (isThesis)
                settings = settings.With(Switches());
            else
                settings.PressureClamp = !Suction;
            double factor = LiquidEnergy.ForceFactor(settings);
            float stiffness = (float)(Sound * Sound / factor);
            settings = isThesis
                ? settings.WithOwn((ref ThesisSettings own) => own.Stiffness = stiffness)
                : settings.WithSoundSpeed(Mathf.Sqrt(stiffness));
            double viscosity = double.IsNaN(Viscosity) ? settings.Viscosity : Viscosity * settings.RestDensity;
            settings.Viscosity = (float)(viscosity / factor);
            settings.Boundaries.Periodic = Periodic;
            return settings;
        }

        // The settings carry the printed method's switches themselves, so that its limit stays off where it is off.
        private ThesisSwitches Switches()
        {
            ThesisSwitches switches = Method.Kind == FluidMethodKind.ThesisPrinted ? ThesisSwitches.Printed : ThesisSwitches.Corrected;
            if (!Clamps) switches.AccelerationLimit = ThesisAccelerationLimit.Off;
            switches.OctantSearch = false; // the same pairs, faster
            switches.PressureClamp &= !Suction;
            return switches;
        }
    }
}
