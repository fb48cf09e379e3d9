namespace UnityEngine.Rendering;

public enum RenderBufferLoadAction
{
    Load = 0,
    Clear = 1,
    DontCare = 2,
}
