using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal;

/// <summary>Drawing settings as all passes of the pipeline have them.</summary>
internal static class Drawing
{
    public static DrawingSettings Settings(IReadOnlyList<ShaderTagId> tags, ContextContainer frame, SortingCriteria criteria)
    {
        UniversalCameraData camera = frame.Get<UniversalCameraData>();
        UniversalRenderingData rendering = frame.Get<UniversalRenderingData>();
        UniversalLightData lights = frame.Get<UniversalLightData>();
        var settings = new DrawingSettings(tags[0], new SortingSettings(camera.camera) { criteria = criteria })
        {
            perObjectData = rendering.perObjectData,
            mainLightIndex = lights.mainLightIndex,
            enableDynamicBatching = rendering.supportsDynamicBatching,
            enableInstancing = camera.cameraType != CameraType.Preview,
        };
        for (int i = 1; i < tags.Count; i++)
        {
            settings.SetShaderPassName(i, tags[i]);
        }

        return settings;
    }
}
