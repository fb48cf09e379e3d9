namespace Headless.Shaders;

/// <param name="ShaderName">Name of the shader the pass belongs to.</param>
/// <param name="Name">Name of the pass, "" where none is given.</param>
/// <param name="Tags">Tags of the pass itself, such as LightMode; keys compare without case.</param>
public sealed record ShaderPass(
    string ShaderName, string Name, IReadOnlyDictionary<string, string> Tags, RenderState State, ShaderProgram Program)
{
    /// <summary>What the macros that follow from the LightMode tag begin with.</summary>
    internal const string DefinePrefix = "UNITY_PASS_";

    /// <summary>Why the pass can be read but not compiled here; null when it can.</summary>
    internal UnsupportedFeature? Unsupported { get; init; }

    /// <summary>A pass is itself only: it serves as a key.</summary>
    public bool Equals(ShaderPass? other) => ReferenceEquals(this, other);

    public override int GetHashCode() => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(this);

    /// <summary>Macros that follow from the LightMode tag: UNITY_PASS_FORWARDBASE, ...</summary>
    internal IReadOnlyList<KeyValuePair<string, string>> Defines
    {
        get
        {
            string? mode = Tags.GetValueOrDefault("LightMode")?.ToUpperInvariant();
            return mode is "FORWARDBASE" or "FORWARDADD" or "SHADOWCASTER" or "DEFERRED" or "META"
                ? [KeyValuePair.Create(DefinePrefix + mode, "1")]
                : [];
        }
    }
}
