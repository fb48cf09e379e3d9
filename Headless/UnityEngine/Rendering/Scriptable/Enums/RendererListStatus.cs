namespace UnityEngine.Rendering;

public enum RendererListStatus
{
    kRendererListInvalid = -2,
    kRendererListProcessing = -1,
    kRendererListEmpty = 0,
    kRendererListPopulated = 1,
}
