namespace SphFluid
{
    /// <summary>What a render pipeline lets water show, in words for the inspector.</summary>
    internal readonly struct WaterRoute
    {
        private WaterRoute(bool isComplete, string text)
        {
            IsComplete = isComplete;
            Text = text;
        }

        /// <summary>Whether nothing is missing.</summary>
        public bool IsComplete { get; }

        /// <summary>Where the scene behind the water comes from, and what is missing.</summary>
        public string Text { get; }

        /// <summary>The route of the pipeline that draws now.</summary>
        public static WaterRoute Active => Choose(DrawPipeline.Active, WaterCameras.Universal);

        /// <summary>The route of a pipeline.</summary>
        /// <param name="kind">The pipeline.</param>
        /// <param name="universal">The Universal Render Pipeline's textures; null without the package's assembly for it.</param>
        public static WaterRoute Choose(DrawPipelineKind kind, ISceneTextureSource universal)
        {
            switch (kind)
            {
                case DrawPipelineKind.BuiltIn:
                    return new WaterRoute(true,
                        "Built-in pipeline: the water refracts a copy of each camera's picture, made before transparent objects.");
                case DrawPipelineKind.Universal when universal != null:
                    return OfRenderer(universal.Limit);
                case DrawPipelineKind.HighDefinition:
                    return new WaterRoute(false,
                        "High Definition Render Pipeline: the water is blended over the scene. Refraction, reflection probes and shadows " +
                        "are missing.");
                default:
                    return new WaterRoute(false, "This render pipeline gives the water no picture of the scene: it is blended over it. " +
                        "Refraction is missing; it needs the Built-in pipeline or the Universal Render Pipeline 14 or newer.");
            }
        }

        private static WaterRoute OfRenderer(RendererLimit limit)
        {
            switch (limit)
            {
                case RendererLimit.TileOnly:
                    return new WaterRoute(false,
                        "Universal Renderer in Tile-Only Mode: it keeps no picture of the scene, and the water is blended over it. " +
                        "Refraction is missing; turn Tile-Only Mode off in the renderer's asset.");
                case RendererLimit.TwoDimensional:
                    return new WaterRoute(false,
                        "2D Renderer: it copies no picture of the scene, and the water is blended over it. Refraction is missing; " +
                        "give the pipeline's asset, or the camera, a Universal Renderer.");
                default:
                    return new WaterRoute(true,
                        "Universal Render Pipeline: the water refracts the opaque texture, which is asked for each frame.");
            }
        }
    }
}
