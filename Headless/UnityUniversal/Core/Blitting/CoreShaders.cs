using System.Reflection;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>The shaders that the two packages bring with them, by Unity's names.</summary>
internal static class CoreShaders
{
    static CoreShaders() => Add(typeof(CoreShaders).Assembly, "Hidden/Universal/CoreBlit", "CoreBlit.shader");

    public static void Add(Assembly assembly, string name, string file) => ShaderLibrary.AddBuiltin(assembly, name, file);

    public static Shader Find(string name) => ShaderLibrary.Require(name);
}
