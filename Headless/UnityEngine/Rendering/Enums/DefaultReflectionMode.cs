namespace UnityEngine.Rendering;

public enum DefaultReflectionMode
{
    Skybox = 0,
    Custom = 1,
}
