using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Constants of a cell, each set directly: speed of sound, viscosity and time step are the axes of the maps and follow no rule.
    /// c is the nominal speed of sound, √k, as the linear theory has it: waves run at √(k/2) with the ½ of the thesis's equation (13).
    /// </summary>
    struct StabilityConstants
    {
        /// <summary>κ = R/dx without another.</summary>
        public const double SupportRatio = 2.0;

        /// <summary>Particle spacing of all scenes [m].</summary>
        public const double Spacing = 0.1;

        public CaseMethod Method;
        public Vector3 DomainSize;

        /// <summary>κ = R/dx.</summary>
        public double Support;

        /// <summary>c = √k [m/s].</summary>
        public double Sound;

        /// <summary>ν [m²/s]; not a number: that of the package's rules, 0.01 c_eff R.</summary>
        public double Viscosity;

        /// <summary>dt [s].</summary>
        public double TimeStep;

        /// <summary>Speed that walls are made for [m/s].</summary>
        public double Speed;

        public Vector3 Gravity;
        public FluidAxes Periodic;

        /// <summary>Whether the emergency limit on accelerations acts.</summary>
        public bool Clamps;

        /// <summary>Whether negative pressures may act: a box full of liquid has no surface that they could tear.</summary>
        public bool Suction;

        public FluidSolverSettings Settings()
        {
            bool printed = Method.Kind == FluidMethodKind.ThesisPrinted;
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = DomainSize;
            input.Spacing = (float)Spacing;
            input.Gravity = Gravity;
            input.SupportRatio = (float)Support;
            input.MinSpeed = (float)Speed;
            input.MaxCompression = 1f;
            input.SoundSpeedRatio = (float)(Sound / Math.Sqrt(2.0) / Speed);
            FluidSolverSettings settings = FluidSolverSettings.FromRules(input);
            settings.TimeStep = (float)TimeStep;
            ThesisSwitches switches = printed ? ThesisSwitches.Printed : ThesisSwitches.Corrected;
            if (!Clamps)
                switches.AccelerationLimit = ThesisAccelerationLimit.Off;
            switches.OctantSearch = false; // the same pairs, faster
            switches.PressureClamp &= !Suction;
            settings = settings.With(switches);
            double factor = ForceFactor(settings);
            settings.Stiffness = (float)(Sound * Sound / factor);
            double viscosity = double.IsNaN(Viscosity) ? input.ViscosityRatio * Sound / Math.Sqrt(2.0) * settings.SupportRadius : Viscosity;
            settings.Viscosity = (float)(viscosity * settings.RestDensity / factor);
            settings.Boundaries.Periodic = Periodic;
            return settings;
        }

        /// <summary>A run of these settings; they hold the method's switches already, so that the limit stays off where it is off.</summary>
        public static CaseMethod Runner => CaseMethod.Find("thesis");

        /// <summary>Speed at which waves run [m/s].</summary>
        public static double EffectiveSound(in FluidSolverSettings settings) => settings.SoundSpeed * Math.Sqrt(ForceFactor(settings));

        // 6.3.3 as printed multiplies the force density by m where the equation divides by ρ: m ρ times the acceleration.
        static double ForceFactor(in FluidSolverSettings settings) =>
            settings.ForceTimesMass ? (double)settings.ParticleMass * settings.RestDensity : 1.0;
    }
}
