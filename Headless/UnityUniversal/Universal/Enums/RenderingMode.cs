namespace UnityEngine.Rendering.Universal;

public enum RenderingMode
{
    Forward = 0,
    ForwardPlus = 2,
    Deferred = 1,
}
