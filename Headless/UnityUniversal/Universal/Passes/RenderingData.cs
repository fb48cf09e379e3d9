namespace UnityEngine.Rendering.Universal;

public struct RenderingData
{
}
