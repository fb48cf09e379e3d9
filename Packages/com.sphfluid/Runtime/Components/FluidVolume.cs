using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Liquid at the start: a box, a sphere or a mesh, moved, turned and scaled with this transform, or the hollow of the colliders
    /// round it. A simulation may have several; where they overlap, liquid is filled once and the first in the hierarchy gives the
    /// velocity. Enabled while the liquid runs, a volume adds its liquid then (methods Standard and Robust), where there is a place for it.
    /// Moved or changed while the liquid runs, a volume moves no liquid; disabled, it takes none away.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Volume")]
    [ManualPage("filling", "add-liquid")]
    public sealed class FluidVolume : MonoBehaviour, IFluidPart<VolumeSpec>
    {
        [SerializeField,
            Tooltip(
                "What is filled at the start, or when the volume is enabled while the liquid runs. Box and Sphere: of the size below. " +
            "Mesh: the inside of a closed mesh. Vessel: the hollow of the colliders around this object, up to a level.")]
        private FluidVolumeShape shape;

        [SerializeField, Unit("m"),
            Tooltip("Edge lengths of the box in this transform's space, in metres where its scale is one. A sphere touches its faces.")]
        private Vector3 size = new Vector3(0.5f, 0.5f, 0.5f);

        [SerializeField, Tooltip("Closed mesh that is filled, with Read/Write on. Empty: that of this object's Mesh Filter.")]
        private Mesh mesh;

        [SerializeField, Unit("m"), Min(0f),
            Tooltip("Height of the liquid's surface above this object in metres, against gravity. The object lies in the hollow, " +
            "below the surface.")]
        private float level = 0.25f;

        [SerializeField,
            Tooltip("The faces of the domain hold the liquid too. Off: liquid that reaches one has run out of the vessel, an error.")]
        private bool domainHolds;

        [SerializeField, Unit("m/s"),
            Tooltip("Velocity of the liquid at the start in m/s, in this transform's axes; scale does not change it.")]
        private Vector3 initialVelocity;

        [SerializeField, Tooltip("Simulation that this liquid belongs to. Empty: the simulation among its parents, else the only one " +
            "in the scene, else the one whose domain holds the centre of the box.")]
        private FluidSimulation simulation;

        /// <summary>
        /// What is filled. Read when the simulation starts, or when the volume is enabled while it runs, as all the rest.
        /// </summary>
        public FluidVolumeShape Shape { get => Limits.Known(shape); set => shape = value; }

        /// <summary>Edge lengths in this transform's space [m at unit scale] of the box, or of the box that the sphere touches.</summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Closed mesh that is filled, in this transform's space; null: that of the object's MeshFilter.</summary>
        public Mesh Mesh { get => mesh; set => mesh = value; }

        /// <summary>
        /// Height of a vessel's surface above this transform [m], against gravity; with no gravity, along the world's y axis.
        /// </summary>
        public float Level { get => level; set => level = value; }

        /// <summary>Whether the domain's faces hold a vessel's liquid too; else liquid that reaches one has run out, an error.</summary>
        public bool DomainHolds { get => domainHolds; set => domainHolds = value; }

        /// <summary>Velocity at the start in this transform's axes [m/s].</summary>
        public Vector3 InitialVelocity { get => initialVelocity; set => initialVelocity = value; }

        /// <summary>Simulation that this liquid belongs to; null: found as the tooltip says.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>What is filled, as of now.</summary>
        internal VolumeSpec Spec => new VolumeSpec
        {
            Owner = this,
            Position = transform.position,
            Rotation = transform.rotation,
            LocalToWorld = transform.localToWorldMatrix,
            Shape = Shape,
            Size = size,
            FilledMesh = FilledMesh,
            Level = level,
            DomainHolds = domainHolds,
            InitialVelocity = initialVelocity,
        };

        /// <summary>The mesh that shape Mesh fills; null when there is none.</summary>
        internal Mesh FilledMesh => mesh != null ? mesh : TryGetComponent(out MeshFilter filter) ? filter.sharedMesh : null;

        VolumeSpec IFluidPart<VolumeSpec>.Spec => Spec;

        Component IFluidPart<VolumeSpec>.Named => simulation;

        private void OnEnable() => FluidParts<VolumeSpec>.Add(this);

        private void OnDisable() => FluidParts<VolumeSpec>.Remove(this);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics() => FluidParts<VolumeSpec>.Clear();
    }
}
