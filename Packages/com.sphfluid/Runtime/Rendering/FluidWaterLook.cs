using System;
using UnityEngine;
using UnityEngine.Serialization;

namespace SphFluid
{
    /// <summary>How clear water looks.</summary>
    [Serializable]
    public sealed class FluidWaterLook
    {
        // Contrast that is left at the visibility: 2 % (Koschmieder 1924), so a coefficient of 3.912 / visibility.
        private const float VisibilityConstant = 3.912f;

        // Spray shows as much of the liquid's colour as scattered light has of it after so long a way [m]; that of a body of it is what is
        // left of white light after another.
        private const float WayInSpray = 0.1f;
        private const float WayInBody = 0.4f;

        // A channel that a metre of water swallows whole would have an infinite coefficient.
        private const float LeastTransmittance = 1e-3f;

        private const float LeastDistance = 1e-4f; // m
        private const float ClearestMatt = 0.3f; // m

        private const float WaterReflectance = 0.02f; // ((n - 1) / (n + 1))² at n = 1.33

        [SerializeField, FormerlySerializedAs("colourAtOneMetre"),
            Tooltip("Colour that white light has after the Absorption Distance, by default one metre.")]
        private Color colorAtOneMetre = new Color(0.1f, 0.52f, 0.83f);

        [SerializeField, Min(LeastDistance),
            Tooltip("Distance after which white light has that colour [m]. Small: dark already where it is thin, as blood or syrup.")]
        private float absorptionDistance = 1f;

        [SerializeField, Min(0.01f), Tooltip("How far one sees in it [m]. Small: milky.")]
        private float visibility = 8f;

        [SerializeField, Tooltip("Colour of the light that it scatters back: white for water, brown for a river.")]
        private Color scattering = Color.white;

        [SerializeField, ColorUsage(false, true),
            Tooltip("Light that it gives off by itself where it is thick, as lava does; black: none. It lights nothing else.")]
        private Color emission = Color.black;

        [SerializeField, Range(WaterReflectance, 1f),
            Tooltip("Share of the light that its surface mirrors head-on. 0.02: water; 0.04: honey; 0.8: liquid metal.")]
        private float reflectance = WaterReflectance;

        [SerializeField, Range(0f, 1f), Tooltip("How much the scene behind is displaced. 1: as much as by water.")]
        private float refraction = 1f;

        [SerializeField, Range(0f, 1f), Tooltip("How small and bright the sun's highlights are.")]
        private float smoothness = 0.9f;

        [SerializeField, Range(0f, 1f), Tooltip("How dark its shadow is. Low values suit clear water, which lets most light through.")]
        private float shadow = 0.25f;

        [SerializeField, Range(0f, 1f),
            Tooltip("Bright lines of sunlight that waves gather on what stands in the water. 1: as in nature; 0: none, at no cost.")]
        private float caustics;

        [SerializeField,
            Tooltip(
                "How closely light is followed through the water. Fast: bent once. Balanced: followed to what it meets. Fine: in small " +
                "steps, and mirrored by the walls of a tank.")]
        private FluidWaterQuality quality = FluidWaterQuality.Fine;

        [SerializeField, Tooltip("Whether its thickness is measured at half the picture's resolution: cheaper, a little softer at edges.")]
        private bool halfResolution;

        [SerializeField, Range(0, MostDrops),
            Tooltip(
                "Number of small drops that a lone particle is drawn as. 0: it stays in the surface, as a ball of water. More: finer, " +
                "more expensive spray.")]
        private int spray = 14;

        [SerializeField, Range(0f, 0.02f),
            Tooltip("How long the camera's shutter is open for spray [s]: fast drops are drawn as streaks along their way.")]
        private float sprayShutter = 1f / 400f;

        /// <summary>Most drops of <see cref="Spray"/>.</summary>
        public const int MostDrops = 32;

        /// <summary>
        /// Colour that white light has after <see cref="AbsorptionDistance"/>, by default one metre. Not a number counts as 0.
        /// </summary>
        public Color ColorAtOneMetre { get => Limits.Finite(colorAtOneMetre); set => colorAtOneMetre = value; }

        /// <summary>Distance after which white light has <see cref="ColorAtOneMetre"/> [m], 0.0001 or more; 1 by default.</summary>
        public float AbsorptionDistance { get => Limits.Clamp(absorptionDistance, LeastDistance); set => absorptionDistance = value; }

        /// <summary>
        /// How far one sees in it [m], 0.01 or more: at that distance 2 % of the contrast is left; infinity counts as the largest number,
        /// and nothing scatters.
        /// </summary>
        public float Visibility { get => Limits.Clamp(visibility, 0.01f); set => visibility = value; }

        /// <summary>Colour of the light that it scatters back. Not a number counts as 0.</summary>
        public Color Scattering { get => Limits.Finite(scattering); set => scattering = value; }

        /// <summary>
        /// Light that it gives off by itself where it is thick, with values above 1 for what shines; black by default. Liquid of a short
        /// sight has a skin and gives off less where it lies flat. It lights nothing else. Not a number counts as 0.
        /// </summary>
        public Color Emission { get => Limits.Finite(emission); set => emission = value; }

        /// <summary>Share of the light that its surface mirrors seen at a right angle, 0.02 to 1; 0.02, water's, by default.</summary>
        public float Reflectance { get => Limits.Clamp(reflectance, WaterReflectance, 1f); set => reflectance = value; }

        /// <summary>How much the scene behind is displaced, 0 to 1; 1: as much as by water.</summary>
        public float Refraction { get => Limits.Clamp(refraction, 0f, 1f); set => refraction = value; }

        /// <summary>Smoothness of the surface, 0 to 1.</summary>
        public float Smoothness { get => Limits.Clamp(smoothness, 0f, 1f); set => smoothness = value; }

        /// <summary>How much of the light its shadow takes away, 0 to 1.</summary>
        public float Shadow { get => Limits.Clamp(shadow, 0f, 1f); set => shadow = value; }

        /// <summary>
        /// How strong the bright lines are that waves gather of the main light on opaque things in the water, 0 to 1; 0, none and at no
        /// cost, by default.
        /// </summary>
        public float Caustics { get => Limits.Clamp(caustics, 0f, 1f); set => caustics = value; }

        /// <summary>How closely light is followed through the water.</summary>
        public FluidWaterQuality Quality { get => Limits.Known(quality); set => quality = value; }

        /// <summary>Whether its thickness is measured at half the picture's resolution.</summary>
        public bool HalfResolution { get => halfResolution; set => halfResolution = value; }

        /// <summary>
        /// Small drops that a particle far from others is drawn as, 0 to <see cref="MostDrops"/>; 0: it stays in the surface.
        /// </summary>
        public int Spray { get => Mathf.Clamp(spray, 0, MostDrops); set => spray = value; }

        /// <summary>How long the camera's shutter is open for spray [s], 0 to 0.02: drops are streaked by the way they go in it.</summary>
        public float SprayShutter { get => Limits.Clamp(sprayShutter, 0f, 0.02f); set => sprayShutter = value; }

        /// <summary>
        /// Steps through the water, steps behind it, whether walls mirror, and steps of what the surface mirrors;
        /// Shaders/Rendering/WaterRefraction.hlsl.
        /// </summary>
        internal Vector4 RefractionSteps
        {
            get
            {
                switch (Quality)
                {
                    case FluidWaterQuality.Fast:
                        return Vector4.zero;
                    case FluidWaterQuality.Balanced:
                        return new Vector4(6f, 3f, 0f, 6f);
                    default:
                        return new Vector4(12f, 6f, 1f, 12f);
                }
            }
        }

        /// <summary>Light absorbed or scattered a metre [1/m], in the colours that shaders use.</summary>
        internal Vector4 Extinction
        {
            get
            {
                Vector4 scattered = ScatteringCoefficient;
                Color left = InShaderColours(ColorAtOneMetre);
                return new Vector4(Absorption(left.r) + scattered.x, Absorption(left.g) + scattered.y,
                    Absorption(left.b) + scattered.z, 0f);
            }
        }

        /// <summary>Share of the extinction that is scattered rather than absorbed, 0 to 1.</summary>
        internal Vector4 Albedo
        {
            get
            {
                Vector4 scattered = ScatteringCoefficient;
                Vector4 all = Extinction;
                return new Vector4(Share(scattered.x, all.x), Share(scattered.y, all.y), Share(scattered.z, all.z), 0f);
            }
        }

        /// <summary>
        /// Colour of drops and mist in white light: between white, where drops are clear, and that of a body of the liquid, so that its hue
        /// is the liquid's. Drops are lit all round: what they scatter forwards, which a body swallows, is seen as well.
        /// </summary>
        internal Vector4 SprayColor
        {
            get
            {
                Vector4 lost = Extinction;
                Vector4 scattered = Albedo;
                Vector4 body = Vector4.one;
                float turned = 0f;
                for (int c = 0; c < 3; c++)
                {
                    float left = Mathf.Exp(-lost[c] * WayInBody);
                    float back = 0.5f * scattered[c] * (1f - left);
                    body[c] = left + back;
                    turned += back / 3f;
                }
                float share = 1f - Mathf.Exp(-(lost.x + lost.y + lost.z) / 3f * WayInSpray);
                return Vector4.Lerp(Vector4.one, body / (1f - turned), share);
            }
        }

        /// <summary>Light that drops and mist give off: <see cref="Emission"/>, as much as a layer as thick as a drop does.</summary>
        internal Vector4 SprayGlow
        {
            get
            {
                Vector4 given = Surface;
                Vector4 lost = Extinction;
                Vector4 glow = Vector4.zero;
                for (int c = 0; c < 3; c++) glow[c] = given[c] * (1f - Mathf.Exp(-lost[c] * WayInSpray));
                return glow;
            }
        }

        private Vector4 ScatteringCoefficient
        {
            get
            {
                Color tint = InShaderColours(Scattering);
                return new Vector4(tint.r, tint.g, tint.b, 0f) * (Visibility < float.MaxValue ? VisibilityConstant / Visibility : 0f);
            }
        }

        /// <summary>rgb: <see cref="Emission"/> in the colours that shaders use; w: <see cref="Reflectance"/>.</summary>
        internal Vector4 Surface
        {
            get
            {
                Color given = InShaderColours(Emission);
                return new Vector4(given.r, given.g, given.b, Reflectance);
            }
        }

        /// <summary>
        /// How much it is lit as a matt body and not as a cloud, 0 to 1: liquid of a short sight sends back light from where it enters.
        /// </summary>
        internal float Matt => Mathf.Clamp01(1f - Visibility / ClearestMatt);

        private float Absorption(float left) => -Mathf.Log(Mathf.Clamp(left, LeastTransmittance, 1f)) / AbsorptionDistance;

        private static float Share(float part, float whole) => whole > 0f ? part / whole : 0f;

        private static Color InShaderColours(Color color) => QualitySettings.activeColorSpace == ColorSpace.Linear ? color.linear : color;
    }
}
