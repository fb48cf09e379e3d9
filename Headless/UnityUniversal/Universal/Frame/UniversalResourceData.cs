using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The textures of a camera's frame; those that are not made, or not yet, are invalid handles.</summary>
public class UniversalResourceData : UniversalResourceDataBase
{
    public TextureHandle backBufferColor { get; internal set; }
    public TextureHandle backBufferDepth { get; internal set; }
    public TextureHandle cameraColor { get; set; }
    public TextureHandle cameraDepth { get; set; }
    public TextureHandle mainShadowsTexture { get; set; }
    public TextureHandle additionalShadowsTexture { get; set; }
    public TextureHandle cameraOpaqueTexture { get; internal set; }
    public TextureHandle cameraDepthTexture { get; internal set; }
    public TextureHandle cameraNormalsTexture { get; internal set; }
    public bool isActiveTargetBackBuffer { get; internal set; } = true;
    public TextureHandle activeColorTexture => isActiveTargetBackBuffer ? backBufferColor : cameraColor;
    public TextureHandle activeDepthTexture => isActiveTargetBackBuffer ? backBufferDepth : cameraDepth;

    public override void Reset()
    {
        (backBufferColor, backBufferDepth, cameraColor, cameraDepth) = (default, default, default, default);
        (mainShadowsTexture, additionalShadowsTexture) = (default, default);
        (cameraOpaqueTexture, cameraDepthTexture, cameraNormalsTexture) = (default, default, default);
        isActiveTargetBackBuffer = true;
    }
}
