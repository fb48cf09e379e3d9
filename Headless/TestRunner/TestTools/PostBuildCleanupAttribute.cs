namespace UnityEngine.TestTools;

[AttributeUsage(AttributeTargets.Class | AttributeTargets.Method)]
public class PostBuildCleanupAttribute : Attribute
{
    public PostBuildCleanupAttribute(Type targetClass) => TargetClass = targetClass;

    internal Type TargetClass { get; }
}
