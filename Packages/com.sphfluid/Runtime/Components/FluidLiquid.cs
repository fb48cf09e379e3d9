using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A liquid: how it moves, how it looks, and its spray and foam. A <see cref="FluidSimulation"/> that has one takes its motion from
    /// it, and the <see cref="FluidSurfaceRenderer"/> and <see cref="FluidWhitewater"/> of that simulation draw it, but for those that
    /// have a look of their own. A change acts at once in all of them; another profile starts the simulations again.
    /// </summary>
    [CreateAssetMenu(menuName = "SPH Fluid/Fluid Liquid", fileName = "FluidLiquid", order = 199)]
    [ManualPage("tuning", "liquids")]
    public sealed class FluidLiquid : ScriptableObject
    {
        [Header("Motion")]
        [SerializeField, Tooltip("How it moves: its constants, and how faithfully they are computed.")]
        private FluidProfile profile;

        [SerializeField,
            Tooltip("How it is brought to rest before the first frame, in simulations whose own Start Relaxation is None. " +
            "Method Standard only.")]
        private FluidStartRelaxation startRelaxation;

        [Header("Look")]
        [SerializeField, Tooltip("How its surface is made.")]
        private FluidSurfaceOptions surface = new FluidSurfaceOptions();

        [SerializeField, Tooltip("How it is drawn: as a body that light goes through, like water, or as an opaque one.")]
        private FluidSurfaceLook look = FluidSurfaceLook.Water;

        [SerializeField, Tooltip("How it looks where light goes through it.")]
        private FluidWaterLook water = new FluidWaterLook();

        [SerializeField, Tooltip("Colour of the opaque body.")]
        private Color color = new Color(0.06f, 0.4f, 0.66f);

        [SerializeField, Range(0f, 1f), Tooltip("Smoothness of the opaque body: how small and bright its highlights are.")]
        private float smoothness = 0.75f;

        [Header("Spray and Foam")]
        [SerializeField, Tooltip("Whether it makes spray, foam and bubbles, in simulations that have a Fluid Whitewater.")]
        private bool whitewater = true;

        [SerializeField, Min(0f), Tooltip("How much whitewater it makes when it is agitated, relative to water.")]
        private float whitewaterAmount = 1f;

        [SerializeField, Min(0.01f), Unit("s"), Tooltip("How long foam lies on it while it is still, at most [s].")]
        private float foamLife = 3f;

        [SerializeField, Min(0f), Tooltip("Size of drops, flakes of foam and bubbles, relative to those of water.")]
        private float whitewaterSize = 1f;

        [SerializeField, Tooltip("Colour of its foam in white light.")]
        private Color foamColor = new Color(0.93f, 0.97f, 1f);

        [Header("Sources")]
        [SerializeField, TextArea(3, 16), Tooltip("Where its constants come from, and what they leave out.")]
        private string sources = "";

        /// <summary>How it moves.</summary>
        public FluidProfile Profile { get => profile; set => profile = value; }

        /// <summary>
        /// How it is brought to rest before the first frame, in simulations whose own <see cref="FluidSimulationSettings.StartRelaxation"/>
        /// is None; method Standard.
        /// </summary>
        public FluidStartRelaxation StartRelaxation { get => Limits.Known(startRelaxation); set => startRelaxation = value; }

        /// <summary>How its surface is made.</summary>
        public FluidSurfaceOptions Surface => surface;

        /// <summary>How it is drawn: as a body that light goes through, like water, or as an opaque one.</summary>
        public FluidSurfaceLook Look { get => Limits.Known(look); set => look = value; }

        /// <summary>How it looks where light goes through it.</summary>
        public FluidWaterLook Water => water;

        /// <summary>Colour of the opaque body. Not a number counts as 0.</summary>
        public Color Color { get => Limits.Finite(color); set => color = value; }

        /// <summary>Smoothness of the opaque body, 0 to 1.</summary>
        public float Smoothness { get => Limits.Clamp(smoothness, 0f, 1f); set => smoothness = value; }

        /// <summary>Whether it makes spray, foam and bubbles, in simulations that have a <see cref="FluidWhitewater"/>.</summary>
        public bool Whitewater { get => whitewater; set => whitewater = value; }

        /// <summary>How much whitewater it makes when it is agitated, relative to water; 0 or more.</summary>
        public float WhitewaterAmount { get => Limits.Clamp(whitewaterAmount, 0f); set => whitewaterAmount = value; }

        /// <summary>How long foam lies on it while it is still, at most [s]; 0.01 or more.</summary>
        public float FoamLife { get => Limits.Clamp(foamLife, 0.01f); set => foamLife = value; }

        /// <summary>Size of drops, flakes of foam and bubbles, relative to those of water; 0 or more.</summary>
        public float WhitewaterSize { get => Limits.Clamp(whitewaterSize, 0f); set => whitewaterSize = value; }

        /// <summary>Colour of its foam in white light. Not a number counts as 0.</summary>
        public Color FoamColor { get => Limits.Finite(foamColor); set => foamColor = value; }

        /// <summary>Where its constants are from, and what they leave out; never null.</summary>
        public string Sources { get => sources ?? ""; set => sources = value; }
    }
}
