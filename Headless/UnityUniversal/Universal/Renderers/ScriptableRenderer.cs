using System.Collections.Generic;

namespace UnityEngine.Rendering.Universal;

public abstract class ScriptableRenderer
{
    private readonly List<ScriptableRenderPass> queue = [];

    public void EnqueuePass(ScriptableRenderPass pass) => queue.Add(pass);
}
