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

        /// <summary>Dynamic viscosity µ of equation (15) [Pa s].</summary>
        public float Viscosity;

        /// <summary>Length of a step [s].</summary>
        public float TimeStep;

        /// <summary>Gravity [m/s²], along the axes of the domain box.</summary>
        public Vector3 Gravity;

        /// <summary>Fastest speed that the other constants are made for [m/s].</summary>
        public float MaxSpeed;

        /// <summary>True: negative pressures act as zero. False: they act, which clumps particles at a surface.</summary>
        public bool PressureClamp;

        /// <summary>
        /// True: the grid has cells of 2R, of which the 8 at the particle's octant are searched, as thesis 6.2 has it. False: cells of R,
        /// all 27.
        /// </summary>
        public bool OctantSearch;

        /// <summary>What the faces of the domain do.</summary>
        public FluidBoundaries Boundaries;

        /// <summary>A force by position besides <see cref="Gravity"/>.</summary>
        public FluidBodyForce BodyForce;

        private IMethodSettings own;

        /// <summary>Effective speed of sound c [m/s], from the method's own constants; 0 without them.</summary>
        public readonly float SoundSpeed => own?.SoundSpeed ?? 0f;

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

        /// <summary>The constants that only one method has, a copy.</summary>
        /// <typeparam name="T">Type of that method's constants.</typeparam>
        /// <returns>The constants.</returns>
        /// <exception cref="ArgumentException">The settings are for another method.</exception>
        public readonly T Own<T>() where T : struct, IMethodSettings => own is T mine
            ? mine
            : throw new ArgumentException(
                $"The settings are for the method {Method} and hold no {typeof(T).Name}. Derive them for the method by FluidRules.Derive.");

        /// <summary>These settings with other constants of the method's own.</summary>
        /// <param name="constants">The constants.</param>
        /// <returns>The changed copy.</returns>
        public readonly FluidSolverSettings WithOwn<T>(in T constants) where T : struct, IMethodSettings
        {
            FluidSolverSettings changed = this;
            changed.own = constants;
            return changed;
        }

        /// <summary>These settings with a change to the method's own constants.</summary>
        /// <example><code>settings = settings.WithOwn((ref ThesisSettings own) => own.HalfKick = false);</code></example>
        /// <param name="change">Changes a copy.</param>
        /// <returns>The changed copy.</returns>
        public readonly FluidSolverSettings WithOwn<T>(MethodSettingsChange<T> change) where T : struct, IMethodSettings
        {
            T constants = Own<T>();
            change(ref constants);
            return WithOwn(constants);
        }

        /// <summary>Whether both have equal constants of the method's own.</summary>
        internal readonly bool HasOwnOf(in FluidSolverSettings other) => ReferenceEquals(own, other.own) || Equals(own, other.own);

        /// <summary>These settings with another speed of sound; time step and viscosity stay.</summary>
        /// <param name="speed">Effective speed of sound [m/s].</param>
        /// <returns>The changed copy.</returns>
        public readonly FluidSolverSettings WithSoundSpeed(float speed)
        {
            FluidSolverSettings changed = this;
            changed.own = own.WithSoundSpeed(speed);
            return changed;
        }

        /// <summary>Checks that every constant can be computed with.</summary>
        /// <exception cref="ArgumentException">A constant is out of range; the message names it.</exception>
        public void Validate()
        {
            Require.Size(DomainSize, nameof(DomainSize));
            Require.Positive(Spacing, nameof(Spacing));
            Require.Positive(SupportRadius, nameof(SupportRadius));
            Require.Positive(RestDensity, nameof(RestDensity));
            Require.Positive(ParticleMass, nameof(ParticleMass));
            Require.Positive(TimeStep, nameof(TimeStep));
            Require.NotNegative(Viscosity, nameof(Viscosity));
            Require.NotNegative(MaxSpeed, nameof(MaxSpeed));
            Require.NotNegative(Gravity.magnitude, nameof(Gravity));
            if (own == null)
            {
                throw new ArgumentException($"The settings hold no constants of the method {Method}. Derive them by FluidRules.Derive.");
            }

            own.Validate();
            Boundaries.Validate();
            BodyForce.Validate(Boundaries.Periodic);
            if (Boundaries.Periodic != FluidAxes.None) FluidGrid.For(this);
        }
    }
}
