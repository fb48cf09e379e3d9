using UnityEngine;

namespace Headless.Tests.Rendering;

/// <summary>An image effect.</summary>
public sealed class InvertEffect : MonoBehaviour
{
    public Material? Effect { get; set; }

    private void OnRenderImage(RenderTexture source, RenderTexture destination) => Graphics.Blit(source, destination, Effect!);
}
