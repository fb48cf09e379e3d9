namespace UnityEngine.Rendering.Universal;

/// <summary>The shaders that the package brings with it, by Unity's names.</summary>
internal static class UniversalShaders
{
    static UniversalShaders()
    {
        CoreShaders.Add(typeof(UniversalShaders).Assembly, "Hidden/Universal Render Pipeline/CopyDepth", "CopyDepth.shader");
        CoreShaders.Add(typeof(UniversalShaders).Assembly, "Hidden/Universal Render Pipeline/Sampling", "Sampling.shader");
    }

    public static Shader Find(string name) => CoreShaders.Find(name);
}
