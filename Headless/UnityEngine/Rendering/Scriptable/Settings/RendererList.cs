using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>Something to draw that ScriptableRenderContext.Create...RendererList has made; of this frame only.</summary>
public struct RendererList
{
    public static readonly RendererList nullRendererList;

    internal RendererList(RendererListContent content) => Content = content;

    public readonly bool isValid => Content is { IsExpired: false };

    internal RendererListContent? Content { get; }
}
