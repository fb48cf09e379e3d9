using System.Runtime.CompilerServices;

namespace UnityEngine.Rendering.Universal;

/// <summary>The shaders that the package brings with it, by Unity's names.</summary>
internal static class UniversalShaders
{
    private static readonly (string Name, string File)[] Files =
    [
        ("Hidden/Universal Render Pipeline/CopyDepth", "CopyDepth.shader"),
        ("Hidden/Universal Render Pipeline/Sampling", "Sampling.shader"),
        ("Universal Render Pipeline/Lit", "Lit.shader"),
        ("Universal Render Pipeline/Simple Lit", "Lit.shader"),
        ("Universal Render Pipeline/Complex Lit", "Lit.shader"),
        ("Universal Render Pipeline/Unlit", "Unlit.shader"),
    ];

    [ModuleInitializer]
    internal static void Register()
    {
        foreach ((string name, string file) in Files)
        {
            CoreShaders.Add(typeof(UniversalShaders).Assembly, name, file);
        }
    }

    public static Shader Find(string name) => CoreShaders.Find(name);
}
