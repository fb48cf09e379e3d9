using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A nozzle from which liquid flows along this transform's forward axis, in layers of particles that keep their distance: liquid of the
    /// rest density leaves with the speed of the nozzle, to which the nozzle's own motion is added. Methods Standard and Robust.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Emitter")]
    [ManualPage("pouring", "pour")]
    public sealed class FluidEmitter : MonoBehaviour, IFluidPart<EmitterSpec>
    {
        private readonly EmitterState state = new EmitterState();

        [SerializeField,
            Tooltip("Liquid that flows. A simulation without its own takes it; otherwise both must be the same. Empty: the simulation's.")]
        private FluidLiquid liquid;

        [SerializeField, Tooltip("Outline of the nozzle, across this transform's forward axis.")]
        private FluidEmitterShape shape;

        [SerializeField, Unit("m"),
            Tooltip(
                "Edge lengths of the nozzle along this transform's x and y axes, in metres where its scale is one. Of a line only the " +
                "first counts, of a mesh none.")]
        private Vector2 size = new Vector2(0.1f, 0.1f);

        [SerializeField,
            Tooltip(
                "Mesh of the nozzle, readable: liquid leaves from its front as seen along this transform's forward axis. Shape Mesh only.")]
        private Mesh mesh;

        [SerializeField, Tooltip("What sets the flow: the speed at the nozzle, or the volume per second.")]
        private FluidEmitterFlow flow;

        [SerializeField, Unit("m/s"), Min(0f), Tooltip("Speed of the liquid at the nozzle in m/s.")]
        private float speed = 1f;

        [SerializeField, Unit("m³/s"), Min(0f), Tooltip("Volume that leaves the nozzle per second in m³/s: 0.001 is a litre.")]
        private float volumeRate = 0.001f;

        [SerializeField, Tooltip("Flow from the moment when the component is enabled.")]
        private bool playOnEnable = true;

        [SerializeField, Unit("s"), Min(0f), Tooltip("Seconds of the liquid's time after which the flow ends. 0: it goes on.")]
        private float duration;

        [SerializeField, Unit("s"), Min(0f),
            Tooltip("Lifetime of this emitter's liquid, in seconds of the liquid's time; then it is removed. 0: it stays.")]
        private float lifetime;

        [SerializeField,
            Tooltip("The nozzle stands in liquid: a pipe, a support radius long, keeps the surrounding liquid out and drives the " +
            "liquid that leaves. The pipe is a wall to liquid, a particle spacing thick, and is not drawn. Off: liquid at the nozzle " +
            "blocks it.")]
        private bool underWater;

        [SerializeField, Tooltip("Simulation that the liquid belongs to. Empty: the simulation among its parents, else the only one " +
            "in the scene, else the one whose domain holds this object.")]
        private FluidSimulation simulation;

        /// <summary>
        /// What flows: a simulation without a liquid of its own takes that of its first emitter with one; null: what is there. Another
        /// than the simulation's is reported as <see cref="FluidIssue.LiquidsDiffer"/>.
        /// </summary>
        public FluidLiquid Liquid { get => liquid; set => liquid = value; }

        /// <summary>Outline of the nozzle.</summary>
        public FluidEmitterShape Shape { get => Limits.Known(shape); set => shape = value; }

        /// <summary>Edge lengths of the nozzle in this transform's space [m at unit scale].</summary>
        public Vector2 Size { get => size; set => size = value; }

        /// <summary>
        /// Mesh of the nozzle, where <see cref="Shape"/> is <see cref="FluidEmitterShape.Mesh"/>, in this transform's space.
        /// </summary>
        public Mesh Mesh { get => mesh; set => mesh = value; }

        /// <summary>What settles the flow: <see cref="Speed"/> or <see cref="VolumeRate"/>.</summary>
        public FluidEmitterFlow Flow { get => Limits.Known(flow); set => flow = value; }

        /// <summary>Speed at the nozzle [m/s], where <see cref="Flow"/> goes by it. A change acts from the next layer on.</summary>
        public float Speed { get => speed; set => speed = value; }

        /// <summary>Volume a second [m³/s], where <see cref="Flow"/> goes by it.</summary>
        public float VolumeRate { get => volumeRate; set => volumeRate = value; }

        /// <summary>Whether the flow begins when the component is enabled.</summary>
        public bool PlayOnEnable { get => playOnEnable; set => playOnEnable = value; }

        /// <summary>Time after which a flow ends [s], 0 or more; 0: it goes on.</summary>
        public float Duration { get => Limits.Clamp(duration, 0f); set => duration = value; }

        /// <summary>
        /// Time after its birth at which a particle leaves the liquid again [s], to the sort of the steps in which it ends; 0: it stays. A
        /// change acts on layers that are emitted from then on. What left is counted by <see cref="FluidSimulation.RemovedParticles"/>. A
        /// liquid with such particles does not sleep.
        /// </summary>
        public float Lifetime { get => lifetime; set => lifetime = value; }

        /// <summary>
        /// Whether the nozzle stands in liquid. It then has a pipe of its own, about 1.1 support radii long from the nozzle on, closed
        /// behind and a wall to liquid, in which all moves at the nozzle's speed. Otherwise liquid at the nozzle blocks it.
        /// </summary>
        public bool UnderWater { get => underWater; set => underWater = value; }

        /// <summary>Simulation that the liquid belongs to; null: found as the tooltip says.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>Whether liquid flows.</summary>
        public bool IsPlaying => isActiveAndEnabled && state.IsOn;

        /// <summary>Volume that came into the liquid [m³], as of a few frames ago.</summary>
        public double EmittedVolume => state.Emitted;

        /// <summary>Volume that found no place, as liquid or a face of the domain was there [m³], as of a few frames ago.</summary>
        public double BlockedVolume => state.Blocked;

        /// <summary>Volume that was not emitted, as the liquid had as many particles as it may have [m³], as of a few frames ago.</summary>
        public double RefusedVolume => state.Refused;

        /// <summary>The emitter as of now.</summary>
        internal EmitterSpec Spec
        {
            get
            {
                Vector3 scale = transform.lossyScale;
                return new EmitterSpec
                {
                    Owner = this,
                    State = state,
                    Liquid = liquid,
                    Position = transform.position,
                    Rotation = transform.rotation,
                    Shape = Shape,
                    Size = new Vector2(size.x * Mathf.Abs(scale.x), size.y * Mathf.Abs(scale.y)),
                    Mesh = mesh,
                    Scale = scale,
                    Flow = Flow,
                    Lifetime = lifetime,
                    UnderWater = underWater,
                    Amount = Flow == FluidEmitterFlow.Speed ? speed : volumeRate,
                };
            }
        }

        /// <summary>Lets liquid flow, for <see cref="Duration"/> where that is given.</summary>
        public void Play()
        {
            state.IsOn = true;
            state.VolumeLeft = double.PositiveInfinity;
            state.TimeLeft = Duration > 0f ? Duration : double.PositiveInfinity;
        }

        /// <summary>Lets a volume flow, to the nearest layer of particles, and stops.</summary>
        /// <param name="volume">The volume [m³].</param>
        /// <exception cref="System.ArgumentOutOfRangeException">It is not a positive number.</exception>
        public void Play(float volume)
        {
            if (!(volume > 0f) || float.IsInfinity(volume))
            {
                throw new System.ArgumentOutOfRangeException(nameof(volume), volume,
                    "The volume must be a positive number of cubic metres.");
            }
            state.IsOn = true;
            state.VolumeLeft = volume;
            state.TimeLeft = double.PositiveInfinity;
        }

        /// <summary>Ends the flow; what has left the nozzle goes on.</summary>
        public void Stop() => state.IsOn = false;

        EmitterSpec IFluidPart<EmitterSpec>.Spec => Spec;

        Component IFluidPart<EmitterSpec>.Named => simulation;

        private void OnEnable()
        {
            FluidParts<EmitterSpec>.Add(this);
            if (playOnEnable) Play();
        }

        private void OnDisable()
        {
            FluidParts<EmitterSpec>.Remove(this);
            state.IsOn = false;
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics() => FluidParts<EmitterSpec>.Clear();
    }
}
