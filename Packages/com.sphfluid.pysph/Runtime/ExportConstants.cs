using UnityEngine;

namespace SphFluid
{
    /// <summary>What an exported case computes with, SI.</summary>
    internal struct ExportConstants
    {
        /// <summary>Edge lengths of the domain [m].</summary>
        public Vector3 DomainSize;

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing;

        /// <summary>Rest density ρ0 [kg/m³].</summary>
        public float Density;

        /// <summary>Kinematic viscosity ν of the real liquid [m²/s].</summary>
        public float Viscosity;

        /// <summary>Speed of sound c by the profile's rules [m/s].</summary>
        public float SoundSpeed;

        /// <summary>Gravity [m/s²], simulation space.</summary>
        public Vector3 Gravity;

        public FluidBoundaries Boundaries;

        /// <summary>Pose of the domain in the world [m].</summary>
        public Vector3 Position;

        public Quaternion Rotation;

        /// <summary>The constants of a simulation.</summary>
        /// <param name="spec">The simulation, with a profile.</param>
        /// <param name="settings">Its solver's constants.</param>
        public static ExportConstants Of(in FluidSpec spec, in FluidSolverSettings settings) => new ExportConstants
        {
            DomainSize = settings.DomainSize,
            Spacing = settings.Spacing,
            Density = settings.RestDensity,
            Viscosity = spec.Profile.Rules.KinematicViscosity,
            SoundSpeed = settings.SoundSpeed,
            Gravity = spec.LocalGravity,
            Boundaries = spec.Boundaries,
            Position = spec.Position,
            Rotation = spec.Rotation,
        };
    }
}
