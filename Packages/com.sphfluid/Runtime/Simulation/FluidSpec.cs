using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What a simulation is to be, as of one moment: the values of its component, its profile and its transform. Everything below the
    /// components takes this in their place.
    /// </summary>
    internal struct FluidSpec
    {
        /// <summary>Fastest that a liquid can be made ready for [m/s].</summary>
        public const float MostSpeed = 1000f;

        /// <summary>
        /// The component: the context of messages, and what is in the scene that is searched. Nothing else is read from it.
        /// </summary>
        public Component Owner;

        /// <summary>World position of the domain's centre [m].</summary>
        public Vector3 Position;

        /// <summary>World rotation of the domain.</summary>
        public Quaternion Rotation;

        /// <summary>World scale of the owner; the liquid needs 1.</summary>
        public Vector3 Scale;

        /// <summary>The liquid whose motion and look it has; null: none.</summary>
        public UnityEngine.Object Liquid;

        /// <summary>What the liquid is; all zero without a profile.</summary>
        public ProfileSpec Profile;

        /// <summary>Whether no face of the domain is a wall, and its size only a limit.</summary>
        public bool IsOpen;

        public Vector3 DomainSize;
        public float Spacing;

        /// <summary>The method; where it is chosen automatically, the one in use.</summary>
        public FluidMethodKind Method;

        /// <summary>What the method is chosen by, where it is chosen automatically.</summary>
        public AutomaticSpec Automatic;

        public LayerMask ColliderLayers;
        public FluidTimeStepMode TimeStepMode;
        public float FixedTimeStep;
        public int MaxSubstepsPerFrame;
        public float ExpectedSpeed;

        /// <summary>Whether liquid at rest takes no steps.</summary>
        public bool SleepsAtRest;

        /// <summary>Whether parts of it that rest take no part in the steps either.</summary>
        public bool PartsSleep;

        /// <summary>Gravity that acts, in world space [m/s²].</summary>
        public Vector3 Gravity;

        /// <summary>What happens when more is emitted than there are slots for.</summary>
        public FluidCapacityPolicy CapacityPolicy;

        /// <summary>Particles that the policies Fixed and RecycleOldest hold; 0: as many as the profile allows.</summary>
        public int Capacity;

        /// <summary>Emitters of this liquid; null for none.</summary>
        public IReadOnlyList<EmitterSpec> Emitters;

        /// <summary>Whose skinned meshes are walls; null for none.</summary>
        public IReadOnlyList<WallSpec> Walls;

        /// <summary>Drains of this liquid; null for none.</summary>
        public IReadOnlyList<DrainSpec> Drains;

        /// <summary>Force zones that act on this liquid; null for none.</summary>
        public IReadOnlyList<ZoneSpec> Zones;

        /// <summary>Where the particles come from of a liquid that is shown and not stepped; null: it is stepped.</summary>
        public IFluidPlayback Playback;

        /// <summary>Emitters, drains and force zones that do nothing while the liquid is shown and not stepped.</summary>
        public int IdleParts;

        /// <summary>What of its detail is given up, as it is far from the cameras.</summary>
        public FluidDetail Detail;

        public FluidBodyForce BodyForce;
        public FluidBoundaries Boundaries;
        public Func<Vector3, Vector3> VelocityField;
        public int Seed;
        public float StartJitter;
        public FluidStartRelaxation StartRelaxation;

        /// <summary>A relaxed start as it was saved; null for none.</summary>
        public TextAsset SavedStart;

        /// <summary>The field that says how large the domain is.</summary>
        public readonly string SizeField => IsOpen ? "Farthest Distance" : "Domain Size";

        /// <summary>The owner's name; read when asked for, as Unity makes a new string each time.</summary>
        public readonly string Name => Owner.name;

        /// <summary>Whether there is a profile.</summary>
        public readonly bool HasProfile => !(Profile.Asset is null);

        /// <summary>The simulation as its settings have it, before an automatic choice changed it.</summary>
        public readonly FluidSpec AsSet()
        {
            FluidSpec spec = this;
            if (!Automatic.IsOn) return spec;
            spec.Profile.Rules = Automatic.AsSet(Profile.Rules);
            spec.MaxSubstepsPerFrame = Automatic.MaxSubsteps;
            return spec;
        }

        /// <summary>Gravity in simulation space [m/s²].</summary>
        public readonly Vector3 LocalGravity => Quaternion.Inverse(Rotation) * Gravity;

        /// <summary>Simulation space to world space.</summary>
        public readonly Matrix4x4 LocalToWorld => DomainSpace.ToWorld(Position, Rotation);

        /// <summary>World space to simulation space.</summary>
        public readonly DomainPose WorldToLocal => DomainSpace.FromWorld(Position, Rotation);

        /// <summary>Most particles that may live.</summary>
        public readonly int MostParticles
        {
            get
            {
                long most = LiquidChecks.MostParticles(this);
                return (int)(CapacityPolicy != FluidCapacityPolicy.Grow && Capacity > 0 ? Math.Min(Capacity, most) : most);
            }
        }

        /// <summary>Slots for particles that are made at the start, however few fill them; 0: as many as there are particles.</summary>
        public readonly int FixedSlots => CapacityPolicy == FluidCapacityPolicy.Fixed && Capacity > 0 ? MostParticles : 0;

        /// <summary>Support radius [m].</summary>
        public readonly float SupportRadius => SupportRatio * Spacing;

        private readonly float SupportRatio => HasProfile ? Profile.Rules.SupportRatio : FluidRuleInput.Water.SupportRatio;

        [OutlivesPlay("it is filled anew, and used at once, by whoever asks")]
        private static readonly List<ColliderState> Pipes = new List<ColliderState>();

        /// <summary>Where to look for colliders; for an owner that is in a scene.</summary>
        public readonly CollisionQuery Query() => new CollisionQuery
        {
            Owner = Owner,
            Scene = Owner.gameObject.scene.GetPhysicsScene(),
            Position = Position,
            Rotation = Rotation,
            DomainSize = DomainSize,
            Layers = ColliderLayers,
            Spacing = Spacing,
            ColliderFriction = FluidMethods.Has(Method, FluidMethodFeatures.ColliderFriction),
            Periodic = Boundaries.Periodic,
            SupportRatio = SupportRatio,
            Others = EmitterPipes.Walls(this, Pipes),
            Walls = Walls,
        };
    }
}
