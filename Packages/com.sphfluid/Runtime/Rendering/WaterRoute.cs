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
        public static WaterRoute Active => Choose(DrawPipeline.Active, WaterCameras.Universal != null);

        /// <summary>The route of a pipeline.</summary>
        /// <param name="kind">The pipeline.</param>
        /// <param name="hasUniversal">Whether the package's assembly for the Universal Render Pipeline is compiled.</param>
        public static WaterRoute Choose(DrawPipelineKind kind, bool hasUniversal)
        {
            switch (kind)
            {
                case DrawPipelineKind.BuiltIn:
                    return new WaterRoute(true,
                        "Built-in pipeline: the water refracts a copy of each camera's picture, made before transparent things are drawn.");
                case DrawPipelineKind.Universal when hasUniversal:
                    return new WaterRoute(true,
                        "Universal Render Pipeline: the water refracts the opaque texture, which is asked for each frame.");
                case DrawPipelineKind.HighDefinition:
                    return new WaterRoute(false,
                        "High Definition Render Pipeline: the water is blended over the scene. Refraction, reflection probes and shadows " +
                        "are missing.");
                default:
                    return new WaterRoute(false, "This render pipeline hands the water no picture of the scene: it is blended over it. " +
                        "Refraction is missing; it needs the Built-in pipeline or the Universal Render Pipeline 14 or newer.");
            }
        }
    }
}
