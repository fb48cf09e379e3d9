using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal;

/// <summary>What the camera and the passes in its queue ask the renderer for.</summary>
/// <param name="Color">The opaque texture.</param>
/// <param name="Depth">The depth texture.</param>
/// <param name="DepthOfCamera">Asked for by the camera or the asset, and so no earlier than the renderer copies it.</param>
/// <param name="Normals">The normals texture.</param>
/// <param name="EarliestDepth">Event of the first pass that reads depth.</param>
internal readonly record struct PassInputs(bool Color, bool Depth, bool DepthOfCamera, bool Normals, RenderPassEvent EarliestDepth)
{
    public static PassInputs Of(IEnumerable<ScriptableRenderPass> queue, UniversalCameraData camera)
    {
        var inputs = new PassInputs(camera.requiresOpaqueTexture, camera.requiresDepthTexture, camera.requiresDepthTexture, false, RenderPassEvent.AfterRenderingTransparents);
        foreach (ScriptableRenderPass pass in queue)
        {
            bool depth = (pass.input & ScriptableRenderPassInput.Depth) != 0;
            bool normals = (pass.input & ScriptableRenderPassInput.Normal) != 0;
            inputs = inputs with
            {
                Color = inputs.Color || (pass.input & ScriptableRenderPassInput.Color) != 0,
                Depth = inputs.Depth || depth || normals,
                Normals = inputs.Normals || normals,
                EarliestDepth = (depth || normals) && pass.renderPassEvent < inputs.EarliestDepth ? pass.renderPassEvent : inputs.EarliestDepth,
            };
        }

        return inputs;
    }
}
