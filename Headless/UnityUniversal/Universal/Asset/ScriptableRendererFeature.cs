using System;

namespace UnityEngine.Rendering.Universal;

/// <summary>Adds passes to a renderer, camera by camera.</summary>
public abstract class ScriptableRendererFeature : ScriptableObject, IDisposable
{
    [SerializeField] private bool m_Active = true;

    public bool isActive => m_Active;

    public abstract void Create();

    public abstract void AddRenderPasses(ScriptableRenderer renderer, ref RenderingData renderingData);

    public virtual void SetupRenderPasses(ScriptableRenderer renderer, in RenderingData renderingData)
    {
    }

    public virtual void OnCameraPreCull(ScriptableRenderer renderer, in CameraData cameraData)
    {
    }

    public void SetActive(bool active) => m_Active = active;

    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    protected virtual void Dispose(bool disposing)
    {
    }
}
