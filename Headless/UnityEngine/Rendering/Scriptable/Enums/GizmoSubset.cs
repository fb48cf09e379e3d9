namespace UnityEngine.Rendering;

public enum GizmoSubset
{
    PreImageEffects = 0,
    PostImageEffects = 1,
}
