using UnityEngine;

namespace Headless.Engine;

/// <summary>The sky of a camera that clears to it.</summary>
internal sealed class SkyboxRendererList(ContextCommands owner, Camera camera, Matrix4x4 projection, Matrix4x4 view) : RendererListContent(owner)
{
    private readonly bool isShown = camera.clearFlags == CameraClearFlags.Skybox;

    public override bool IsEmpty => !isShown || RenderSettings.skybox == null;

    public override void Draw()
    {
        if (IsEmpty)
        {
            return;
        }

        (Matrix4x4 viewBefore, Matrix4x4 projectionBefore) = (ViewState.View, ViewState.Projection);
        ViewState.Set(view, projection);
        Sky.Draw();
        ViewState.Set(viewBefore, projectionBefore);
    }
}
