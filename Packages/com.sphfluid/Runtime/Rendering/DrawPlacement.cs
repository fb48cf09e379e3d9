using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Where and how a fluid is drawn: everything that Unity's render call asks besides the shader's own properties.</summary>
    internal readonly struct DrawPlacement
    {
        /// <param name="localToWorld">Simulation space to world space: rotation and translation.</param>
        /// <param name="domainSize">Edges of the domain [m].</param>
        /// <param name="margin">How far the drawing reaches beyond the domain [m].</param>
        /// <param name="layer">Layer of the drawing, 0 to 31.</param>
        /// <param name="castShadows">Whether the drawing casts shadows, where the pipeline lets it.</param>
        /// <param name="receiveShadows">Whether the drawing receives shadows, where the pipeline lets it.</param>
        /// <param name="spacing">Particle spacing dx [m], from which a drawing that receives shadows takes how bumpy it is.</param>
        /// <param name="waterShadow">Strength of the shadow of the water that it is or is in, 0 to 1: that water does not darken
        /// it.</param>
        public DrawPlacement(Matrix4x4 localToWorld, Vector3 domainSize, float margin, int layer, bool castShadows,
            bool receiveShadows = false, float spacing = 0f,
            float waterShadow = 0f)
        {
            LocalToWorld = localToWorld;
            WorldBounds = AffineMath.BoundsOf(localToWorld, domainSize + Vector3.one * (2f * margin));
            Layer = layer;
            Pipeline = DrawPipeline.Active;
            CastShadows = castShadows && DrawPipeline.HasShadows(Pipeline);
            ReceiveShadows = receiveShadows && DrawPipeline.HasShadows(Pipeline);
            Spacing = spacing;
            WaterShadow = waterShadow;
        }

        public Matrix4x4 LocalToWorld { get; }

        public Bounds WorldBounds { get; }

        public int Layer { get; }

        public bool CastShadows { get; }

        /// <summary>
        /// Whether the shaders read the main light's shadows: Unity's own flag of that name does nothing for transparent things.
        /// </summary>
        public bool ReceiveShadows { get; }

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing { get; }

        /// <summary>Strength of the shadow of the water around, 0 to 1.</summary>
        public float WaterShadow { get; }

        /// <summary>The render pipeline that draws.</summary>
        public DrawPipelineKind Pipeline { get; }

        /// <summary>
        /// Render parameters with every field set: Unity's defaults switch everything off and cull at the world's origin.
        /// </summary>
        public RenderParams Parameters(Material material, MaterialPropertyBlock properties)
        {
            return new RenderParams(material)
            {
                camera = null,
                layer = Layer,
                lightProbeUsage = LightProbeUsage.Off,
                matProps = properties,
                motionVectorMode = MotionVectorGenerationMode.Camera,
                receiveShadows = false,
                reflectionProbeUsage = ReflectionProbeUsage.Off,
                rendererPriority = 0,
                renderingLayerMask = 1,
                shadowCastingMode = CastShadows ? ShadowCastingMode.On : ShadowCastingMode.Off,
                worldBounds = WorldBounds,
            };
        }
    }
}
