using System;

namespace UnityEngine.Rendering;

/// <summary>Events of scriptable pipelines. The player draws with the built-in one: they are never raised.</summary>
public static class RenderPipelineManager
{
    public static event Action<ScriptableRenderContext, Camera>? beginCameraRendering
    {
        add { }
        remove { }
    }

    public static event Action<ScriptableRenderContext, Camera>? endCameraRendering
    {
        add { }
        remove { }
    }
}
