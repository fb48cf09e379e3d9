using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A part of space in which liquid is pushed or dragged, whatever else acts on it. The force rises from the zone's surface inwards over
    /// one support radius, as a step in force would make sound: a zone thinner than two never has its full strength. Methods Standard and
    /// Robust.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Force Zone")]
    [ManualPage("force-zones")]
    public sealed class FluidForceZone : MonoBehaviour, IFluidPart<ZoneSpec>
    {
        private readonly ZoneState state = new ZoneState();

        [SerializeField,
            Tooltip(
                "Directional: along this transform's forward axis. Point: towards its centre. Vortex: round its y axis. Wind: drag " +
                "towards a " +
            "velocity along the forward axis. Turbulence: eddies. Damping: drag towards rest.")]
        private FluidForceKind kind;

        [SerializeField,
            Tooltip(
                "Shape of the zone in this transform's space. Collider: this object's Box, Sphere or Capsule Collider; make it a " +
                "trigger, or liquid collides with it.")]
        private FluidZoneShape shape;

        [SerializeField, Unit("m"),
            Tooltip(
                "Edge lengths of the zone in this transform's space, in metres where its scale is one. A sphere has the diameter x, a " +
                "capsule the " +
            "diameter x and the height y. Not used where the shape is the collider's.")]
        private Vector3 size = new Vector3(0.5f, 0.5f, 0.5f);

        [SerializeField, Unit("m/s²"),
            Tooltip("Acceleration in m/s²; gravity is 9.81. Of turbulence the largest along an axis. Not used by Wind and Damping.")]
        private float strength = 10f;

        [SerializeField, Unit("m/s"), Tooltip("Speed of the wind in m/s.")]
        private float windSpeed = 5f;

        [SerializeField, Unit("1/s"), Min(0f),
            Tooltip("Share of the velocity difference that Wind and Damping remove per second, in 1/s.")]
        private float dragRate = 2f;

        [SerializeField, Unit("m"), Min(0f), Tooltip("Size of an eddy of turbulence in metres.")]
        private float eddySize = 0.2f;

        [SerializeField, Unit("s"), Min(0f), Tooltip("Seconds in which the eddies change into others. 0: they stay.")]
        private float eddyTime = 2f;

        [SerializeField, Tooltip("Simulation whose liquid is pushed. Empty: every liquid that the zone reaches.")]
        private FluidSimulation simulation;

        /// <summary>What the zone does. Changes of all fields act from the next frame on.</summary>
        public FluidForceKind Kind { get => Limits.Known(kind); set => kind = value; }

        /// <summary>Shape of the zone.</summary>
        public FluidZoneShape Shape { get => Limits.Known(shape); set => shape = value; }

        /// <summary>Edge lengths in this transform's space [m at unit scale].</summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Acceleration [m/s²].</summary>
        public float Strength { get => strength; set => strength = value; }

        /// <summary>Speed of the wind [m/s].</summary>
        public float WindSpeed { get => windSpeed; set => windSpeed = value; }

        /// <summary>Rate k of the drag −k (v − w) [1/s].</summary>
        public float DragRate { get => dragRate; set => dragRate = value; }

        /// <summary>Size of an eddy [m].</summary>
        public float EddySize { get => eddySize; set => eddySize = value; }

        /// <summary>Time after which eddies have become others [s]; 0: they stay.</summary>
        public float EddyTime { get => eddyTime; set => eddyTime = value; }

        /// <summary>Simulation whose liquid is pushed; null: every one.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>The zone as of now.</summary>
        internal ZoneSpec Spec
        {
            get
            {
                Vector3 scale = transform.lossyScale;
                var spec = new ZoneSpec
                {
                    Owner = this,
                    State = state,
                    Position = transform.position,
                    Rotation = transform.rotation,
                    Kind = Kind,
                    Shape = Shape,
                    ShapeTurn = Quaternion.identity,
                    Size = new Vector3(size.x * Mathf.Abs(scale.x), size.y * Mathf.Abs(scale.y), size.z * Mathf.Abs(scale.z)),
                    Strength = strength,
                    WindSpeed = windSpeed,
                    DragRate = dragRate,
                    EddySize = eddySize,
                    EddyTime = eddyTime,
                };
                if (Shape == FluidZoneShape.Collider) TakeCollider(ref spec, scale);
                return spec;
            }
        }

        // As PhysX scales them: a sphere by the largest scale, a capsule's radius by the larger scale across, its height by that along its
        // axis.
        private void TakeCollider(ref ZoneSpec spec, Vector3 scale)
        {
            TryGetComponent(out Collider collider);
            scale = new Vector3(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
            switch (collider)
            {
                case BoxCollider box:
                    spec.Shape = FluidZoneShape.Box;
                    spec.Position = transform.TransformPoint(box.center);
                    spec.Size = Vector3.Scale(scale, box.size);
                    break;
                case SphereCollider sphere:
                    spec.Shape = FluidZoneShape.Sphere;
                    spec.Position = transform.TransformPoint(sphere.center);
                    spec.Size = 2f * sphere.radius * Mathf.Max(scale.x, Mathf.Max(scale.y, scale.z)) * Vector3.one;
                    break;
                case CapsuleCollider capsule:
                    int axis = capsule.direction;
                    float diameter = 2f * capsule.radius * Mathf.Max(scale[(axis + 1) % 3], scale[(axis + 2) % 3]);
                    spec.Shape = FluidZoneShape.Capsule;
                    spec.Position = transform.TransformPoint(capsule.center);
                    spec.Size = new Vector3(diameter, Mathf.Max(diameter, capsule.height * scale[axis]), diameter);
                    spec.ShapeTurn = axis == 0 ? Quaternion.Euler(0f, 0f, 90f) : axis == 2 ? Quaternion.Euler(90f, 0f, 0f)
                        : Quaternion.identity;
                    break;
            }
        }

        /// <summary>
        /// Gives the liquid in the zone a velocity, besides the one that it has, over the next frame with steps: an explosion, a blow. Full
        /// in the middle of the zone, less within a support radius of its surface.
        /// </summary>
        /// <param name="deltaVelocity">The velocity [m/s], world space; those of several calls add up.</param>
        /// <exception cref="ArgumentException">It is not finite, or more than a fifth of the speed of sound of a liquid that runs and that
        /// the zone acts on.</exception>
        public void Burst(Vector3 deltaVelocity)
        {
            Vector3 sum = state.Burst + deltaVelocity;
            if (!AffineMath.IsFinite(sum))
            {
                throw new ArgumentException($"The velocity {deltaVelocity} is not finite.", nameof(deltaVelocity));
            }
            foreach (FluidSimulation liquid in FluidSimulation.Active)
            {
                if (!liquid.IsRunning || simulation != null && simulation != liquid) continue;
                FluidZones.RequireGentle("A burst", sum.magnitude, liquid.name, liquid.Solver, nameof(deltaVelocity));
            }
            state.Burst = sum;
        }

        ZoneSpec IFluidPart<ZoneSpec>.Spec => Spec;

        Component IFluidPart<ZoneSpec>.Named => simulation;

        private void OnEnable() => FluidParts<ZoneSpec>.Add(this);

        private void OnDisable()
        {
            FluidParts<ZoneSpec>.Remove(this);
            state.Burst = Vector3.zero;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics() => FluidParts<ZoneSpec>.Clear();
    }
}
