using System.Collections.Generic;
using System;
using UnityEngine;

namespace Headless.Engine;

/// <summary>
/// The textures of CommandBuffer.GetTemporaryRT. Unless released by a command they live until the camera has drawn, or
/// until Graphics.ExecuteCommandBuffer is done.
/// </summary>
internal sealed class NamedTemporaries : IDisposable
{
    private readonly Dictionary<int, RenderTexture> textures = [];

    public RenderTexture? Find(int nameId) => textures.GetValueOrDefault(nameId);

    public void Get(int nameId, RenderTextureDescriptor desc, FilterMode filter)
    {
        Release(nameId);
        RenderTexture texture = RenderTexture.GetTemporary(desc);
        texture.filterMode = filter;
        textures[nameId] = texture;
        GlobalProperties.Sheet.SetTexture(nameId, new TextureSlot(texture));
    }

    public void Release(int nameId)
    {
        if (textures.Remove(nameId, out RenderTexture? texture))
        {
            RenderTexture.ReleaseTemporary(texture);
        }
    }

    public void Dispose()
    {
        foreach (RenderTexture texture in textures.Values)
        {
            RenderTexture.ReleaseTemporary(texture);
        }

        textures.Clear();
    }
}
