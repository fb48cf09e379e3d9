namespace UnityEngine.Rendering.Universal;

public abstract class UniversalResourceDataBase : ContextItem
{
}
