namespace UnityEngine.Rendering;

public enum RenderBufferStoreAction
{
    Store = 0,
    Resolve = 1,
    StoreAndResolve = 2,
    DontCare = 3,
}
