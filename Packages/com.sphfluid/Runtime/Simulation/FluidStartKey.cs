using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Settings that only a new start can change; a running simulation whose key differs starts again.</summary>
    internal readonly struct FluidStartKey : IEquatable<FluidStartKey>
    {
        private readonly UnityEngine.Object profile;
        private readonly FluidShaderSet shaders;
        private readonly FluidMethodKind method;
        private readonly Vector3 domainSize, scale;
        private readonly float spacing, supportRatio, jitter;
        private readonly int seed, maxParticles;
        private readonly bool octantSearch, isOpen;
        private readonly FluidAxes periodic;
        private readonly FluidStartRelaxation relaxation;
        private readonly Func<Vector3, Vector3> velocityField;
        private readonly IFluidPlayback playback;

        private FluidStartKey(in FluidSpec spec)
        {
            profile = spec.Profile.Asset;
            shaders = spec.Profile.Shaders;
            supportRatio = spec.Profile.Rules.SupportRatio;
            maxParticles = spec.Profile.MaxParticles;
            octantSearch = BoundaryChecks.SearchesOctants(spec);
            method = spec.Method;
            isOpen = spec.IsOpen;
            domainSize = spec.DomainSize;
            scale = spec.Scale;
            spacing = spec.Spacing;
            jitter = spec.StartJitter;
            seed = spec.Seed;
            periodic = spec.Boundaries.Periodic;
            relaxation = spec.StartRelaxation;
            velocityField = spec.VelocityField;
            playback = spec.Playback;
        }

        public static FluidStartKey Create(in FluidSpec spec) => new FluidStartKey(spec);

        // Same and Equals of numbers, unlike ==, hold for NaN: a wrong number is reported once, not every frame.
        public bool Equals(FluidStartKey other) =>
            ReferenceEquals(profile, other.profile) && ReferenceEquals(shaders, other.shaders) && method == other.method &&
            AffineMath.Same(domainSize, other.domainSize) && (scale - other.scale).sqrMagnitude < 1e-9f && spacing.Equals(other.spacing) &&
            supportRatio.Equals(other.supportRatio) && jitter.Equals(other.jitter) && seed == other.seed &&
            maxParticles == other.maxParticles && octantSearch == other.octantSearch && isOpen == other.isOpen &&
            periodic == other.periodic && relaxation == other.relaxation && velocityField == other.velocityField &&
            ReferenceEquals(playback, other.playback);

        public override bool Equals(object obj) => obj is FluidStartKey other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(method, domainSize, spacing, seed);
    }

    /// <summary>Settings that take effect between two steps of a running simulation.</summary>
    internal readonly struct FluidLiveKey : IEquatable<FluidLiveKey>
    {
        private readonly Vector3 gravity;
        private readonly FluidTimeStepMode mode;
        private readonly bool sleeps, partsSleep;
        private readonly float fixedTimeStep, expectedSpeed;
        private readonly float maxCompression, soundSpeedRatio;
        private readonly int maxSubsteps, revision, substeps;
        private readonly AutomaticSpec automatic;
        private readonly FluidBoundaries boundaries;
        private readonly FluidBodyForce bodyForce;

        private FluidLiveKey(in FluidSpec spec, Vector3 gravity)
        {
            this.gravity = gravity;
            mode = spec.TimeStepMode;
            sleeps = spec.SleepsAtRest;
            partsSleep = spec.PartsSleep;
            fixedTimeStep = spec.FixedTimeStep;
            expectedSpeed = spec.ExpectedSpeed;
            maxSubsteps = spec.MaxSubstepsPerFrame;
            boundaries = spec.Boundaries;
            bodyForce = spec.BodyForce;
            revision = spec.Profile.Revision;
            maxCompression = spec.Profile.Rules.MaxCompression;
            soundSpeedRatio = spec.Profile.Rules.SoundSpeedRatio;
            substeps = spec.Profile.Rules.Substeps;
            automatic = spec.Automatic;
        }

        /// <summary>Settings as a running simulation sees them: gravity turns with the domain.</summary>
        public static FluidLiveKey Create(in FluidSpec spec) => new FluidLiveKey(spec, spec.LocalGravity);

        /// <summary>Settings as the user gave them: turning the domain is no change.</summary>
        public static FluidLiveKey AsGiven(in FluidSpec spec) => new FluidLiveKey(spec, spec.Gravity);

        public bool Equals(FluidLiveKey other) =>
            AffineMath.Same(gravity, other.gravity) && mode == other.mode && sleeps == other.sleeps && partsSleep == other.partsSleep &&
                fixedTimeStep.Equals(other.fixedTimeStep) &&
            expectedSpeed.Equals(other.expectedSpeed) && maxSubsteps == other.maxSubsteps && revision == other.revision &&
            maxCompression.Equals(other.maxCompression) && soundSpeedRatio.Equals(other.soundSpeedRatio) && substeps == other.substeps &&
            automatic.Equals(other.automatic) &&
            boundaries.Equals(other.boundaries) && bodyForce.Equals(other.bodyForce);

        public override bool Equals(object obj) => obj is FluidLiveKey other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(gravity, mode, fixedTimeStep, maxSubsteps, revision);
    }
}
