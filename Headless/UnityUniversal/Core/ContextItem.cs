namespace UnityEngine.Rendering;

public abstract class ContextItem
{
    public abstract void Reset();
}
