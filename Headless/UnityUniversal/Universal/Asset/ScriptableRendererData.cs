using System.Collections.Generic;
using System.Linq;

namespace UnityEngine.Rendering.Universal;

/// <summary>An asset that makes a renderer, with its features.</summary>
public abstract class ScriptableRendererData : ScriptableObject
{
    [SerializeField] internal List<ScriptableRendererFeature> m_RendererFeatures = [];
    [SerializeField] private bool m_UseNativeRenderPass;

    public List<ScriptableRendererFeature> rendererFeatures => m_RendererFeatures;
    public bool useNativeRenderPass { get => m_UseNativeRenderPass; set => m_UseNativeRenderPass = value; }

    internal bool IsInvalidated { get; private set; }

    /// <summary>The renderer is made anew before the next frame.</summary>
    public new void SetDirty() => IsInvalidated = true;

    public bool TryGetRendererFeature<T>(out T? rendererFeature)
        where T : ScriptableRendererFeature => (rendererFeature = m_RendererFeatures.OfType<T>().FirstOrDefault()) != null;

    internal ScriptableRenderer InternalCreate()
    {
        IsInvalidated = false;
        return Create();
    }

    protected abstract ScriptableRenderer Create();

    protected virtual void OnValidate() => SetDirty();

    protected virtual void OnEnable()
    {
    }
}
