namespace UnityEngine.Rendering;

public enum ReflectionProbeClearFlags
{
    Skybox = 1,
    SolidColor = 2,
}
