namespace UnityEngine.Rendering.RenderGraphModule;

public delegate void BaseRenderFunc<PassData, ContextType>(PassData data, ContextType renderGraphContext)
    where PassData : class, new();
