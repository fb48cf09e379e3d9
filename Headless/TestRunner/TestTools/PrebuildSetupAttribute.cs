namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Method)]
public class PrebuildSetupAttribute : Attribute
{
    public PrebuildSetupAttribute(Type targetClass) => TargetClass = targetClass;

    internal Type TargetClass { get; }
}
