namespace UnityEngine;

public enum RenderingPath
{
    UsePlayerSettings = -1,
    VertexLit = 0,
    Forward = 1,
    DeferredShading = 3,
}
