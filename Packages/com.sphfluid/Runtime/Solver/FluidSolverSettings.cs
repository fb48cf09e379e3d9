using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The constants of a running solver, SI, simulation space. A value: copies are independent.</summary>
    public struct FluidSolverSettings
    {
        /// <summary>The method that the constants are for.</summary>
        public FluidMethodKind Method;

        /// <summary>Size of the domain box [m], centred on the origin.</summary>
        public Vector3 DomainSize;

        /// <summary>Particle spacing dx at rest [m].</summary>
        public float Spacing;

        /// <summary>Support radius R of the kernels [m]: the thesis's h.</summary>
        public float SupportRadius;

        /// <summary>Rest density ρ0 [kg/m³].</summary>
        public float RestDensity;

        /// <summary>Mass of a particle m [kg].</summary>
        public float ParticleMass;

        /// <summary>Stiffness k of equation (10) [m²/s²].</summary>
        public float Stiffness;

        /// <summary>Dynamic viscosity µ of equation (15) [Pa s].</summary>
        public float Viscosity;

        /// <summary>Length of a step [s].</summary>
        public float TimeStep;

        /// <summary>Gravity [m/s²], along the axes of the domain box.</summary>
        public Vector3 Gravity;

        /// <summary>
        /// Emergency limit on the fluid's own acceleration [m/s²], for steps of <see cref="TimeStep"/>; gravity, body force and contact are
        /// not limited. A distance a step, so steps of another length scale it by 1/dt², unless <see cref="AccelerationLimitFixed"/>.
        /// </summary>
        public float AccelerationLimit;

        /// <summary>True: <see cref="AccelerationLimit"/> is the same for steps of every length, as 6.3.3 prints it.</summary>
        public bool AccelerationLimitFixed;

        /// <summary>Stiffness of walls per unit mass [1/s²].</summary>
        public float WallStiffness;

        /// <summary>Damping of walls per unit mass [1/s].</summary>
        public float WallDamping;

        /// <summary>Distance at which a wall begins to push [m].</summary>
        public float WallDistance;

        /// <summary>Fastest speed that the other constants are made for [m/s].</summary>
        public float MaxSpeed;

        /// <summary>True: a particle counts itself in its density, equation (11). False: not, as 6.3.1 prints it.</summary>
        public bool SelfDensity;

        /// <summary>True: the ½ of equation (13), which halves the pressure gradient. False: the full gradient.</summary>
        public bool PressureHalf;

        /// <summary>True: negative pressures act as zero. False: equation (10) as printed, which clumps particles at a surface.</summary>
        public bool PressureClamp;

        /// <summary>True: <see cref="AccelerationLimit"/> acts, as 6.3.3 has it.</summary>
        public bool AccelerationLimitEnabled;

        /// <summary>True: acceleration = force × mass [kg], as 6.3.3 prints it. False: f/ρ, equation (9).</summary>
        public bool ForceTimesMass;

        /// <summary>True: cells of 2R, the 8 at the particle's octant are searched, as 6.2 has it. False: cells of R, all 27.</summary>
        public bool OctantSearch;

        /// <summary>True: the first step gives half a kick, so that velocities live between the steps, equation (21).</summary>
        public bool HalfKick;

        /// <summary>
        /// Standard method. True: particles of a cell are ordered by their ids, so that equal runs are equal to the last bit, for one dispatch
        /// more a step. False: by thread timing.
        /// </summary>
        public bool StableOrder;

        /// <summary>
        /// Standard method. True: the density pass lists each particle's neighbours for the motion pass, for some 290 bytes a particle at
        /// κ = 2.25; a device whose largest buffer is too small for that does without. False: both passes search.
        /// </summary>
        public bool NeighbourList;

        /// <summary>What the faces of the domain do.</summary>
        public FluidBoundaries Boundaries;

        /// <summary>A force by position besides <see cref="Gravity"/>.</summary>
        public FluidBodyForce BodyForce;

        /// <summary>Effective speed of sound [m/s]: √(k/2) with the ½ of equation (13), √k without.</summary>
        public float SoundSpeed => Mathf.Sqrt(PressureHalf ? 0.5f * Stiffness : Stiffness);

        /// <summary>Length of the domain along periodic axes [m]; zero along the others.</summary>
        public Vector3 PeriodLength => new Vector3(
            (Boundaries.Periodic & FluidAxes.X) != 0 ? DomainSize.x : 0f,
            (Boundaries.Periodic & FluidAxes.Y) != 0 ? DomainSize.y : 0f,
            (Boundaries.Periodic & FluidAxes.Z) != 0 ? DomainSize.z : 0f);

        /// <summary>Inverse of <see cref="PeriodLength"/> [1/m]; zero along axes with walls.</summary>
        internal Vector3 PeriodRate => new Vector3(
            (Boundaries.Periodic & FluidAxes.X) != 0 ? 1f / DomainSize.x : 0f,
            (Boundaries.Periodic & FluidAxes.Y) != 0 ? 1f / DomainSize.y : 0f,
            (Boundaries.Periodic & FluidAxes.Z) != 0 ? 1f / DomainSize.z : 0f);

        /// <summary>Constants by rule from spacing, depth and speed; see <see cref="ThesisRules"/>.</summary>
        /// <param name="input">What the rules start from.</param>
        /// <returns>The settings.</returns>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public static FluidSolverSettings FromRules(in FluidRuleInput input)
        {
            return input.Method == FluidMethodKind.Standard ? StandardRules.Derive(input) : ThesisRules.Derive(input);
        }

        /// <summary>
        /// These settings with the thesis's text as switched. The stiffness follows the ½ of equation (13), k = 2 c² or c²,
        /// so that the effective speed of sound stays; time step and viscosity stay too.
        /// </summary>
        /// <param name="switches">Corrected, printed, or any mixture.</param>
        /// <returns>The changed copy.</returns>
        public FluidSolverSettings With(in ThesisSwitches switches)
        {
            FluidSolverSettings settings = this;
            settings.SelfDensity = switches.SelfDensity;
            settings.PressureClamp = switches.PressureClamp;
            settings.PressureHalf = switches.PressureHalf;
            settings.ForceTimesMass = switches.ForceTimesMass;
            settings.HalfKick = switches.HalfKick;
            settings.OctantSearch = switches.OctantSearch;
            settings.AccelerationLimitEnabled = switches.AccelerationLimit != ThesisAccelerationLimit.Off;
            settings.AccelerationLimit = switches.AccelerationLimit == ThesisAccelerationLimit.AsPrinted
                ? MaxSpeed
                : ThesisRules.EmergencyLimit(Spacing, TimeStep);
            settings.AccelerationLimitFixed = switches.AccelerationLimit == ThesisAccelerationLimit.AsPrinted;
            if (PressureHalf != switches.PressureHalf)
            {
                settings.Stiffness = switches.PressureHalf ? 2f * Stiffness : 0.5f * Stiffness;
            }

            return settings;
        }

        /// <summary>Checks that every constant can be computed with.</summary>
        /// <exception cref="ArgumentException">A constant is out of range; the message names it.</exception>
        public void Validate()
        {
            RequirePositive(DomainSize.x, nameof(DomainSize));
            RequirePositive(DomainSize.y, nameof(DomainSize));
            RequirePositive(DomainSize.z, nameof(DomainSize));
            RequirePositive(Spacing, nameof(Spacing));
            RequirePositive(SupportRadius, nameof(SupportRadius));
            RequirePositive(RestDensity, nameof(RestDensity));
            RequirePositive(ParticleMass, nameof(ParticleMass));
            RequirePositive(Stiffness, nameof(Stiffness));
            RequirePositive(TimeStep, nameof(TimeStep));
            RequirePositive(AccelerationLimit, nameof(AccelerationLimit));
            RequireNotNegative(Viscosity, nameof(Viscosity));
            RequireNotNegative(WallStiffness, nameof(WallStiffness));
            RequireNotNegative(WallDamping, nameof(WallDamping));
            RequireNotNegative(WallDistance, nameof(WallDistance));
            RequireNotNegative(Gravity.magnitude, nameof(Gravity));
            Boundaries.Validate(Method);
            BodyForce.Validate(Boundaries.Periodic);
            if (Boundaries.Periodic != FluidAxes.None)
            {
                FluidGrid.For(this);
            }
        }

        // The emergency is a way of one spacing in a step from rest.
        internal float AccelerationLimitAt(float step)
        {
            double ratio = AccelerationLimitFixed ? 1.0 : TimeStep / (double)step;
            return (float)(AccelerationLimit * ratio * ratio);
        }

        internal static void RequirePositive(float value, string name)
        {
            if (!(value > 0f) || float.IsInfinity(value))
            {
                throw new ArgumentException($"{name} is {value}; it must be a positive number.", name);
            }
        }

        internal static void RequireNotNegative(float value, string name)
        {
            if (!(value >= 0f) || float.IsInfinity(value))
            {
                throw new ArgumentException($"{name} is {value}; it must be zero or a positive number.", name);
            }
        }
    }
}
