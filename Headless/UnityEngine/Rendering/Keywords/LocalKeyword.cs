using System;

namespace UnityEngine.Rendering;

public readonly struct LocalKeyword : IEquatable<LocalKeyword>
{
    private readonly LocalKeywordSpace space;

    public LocalKeyword(Shader shader, string name)
        : this(Require(shader).keywordSpace, name, shader.name)
    {
    }

    public LocalKeyword(ComputeShader shader, string name)
        : this(Require(shader).keywordSpace, name, shader.name)
    {
    }

    internal LocalKeyword(LocalKeywordSpace space, string name)
    {
        this.space = space;
        this.name = name;
    }

    private LocalKeyword(LocalKeywordSpace space, string name, string owner)
    {
        this.space = space;
        this.name = name;
        if (!space.Declares(name))
        {
            Debug.LogError($"Local keyword {name} doesn't exist in the shader {owner}.");
        }
    }

    public string name { get; }
    public bool isValid => name is not null && space.Declares(name);
    public bool isOverridable => isValid;
    public bool isDynamic => false;
    public ShaderKeywordType type => isValid ? ShaderKeywordType.UserDefined : ShaderKeywordType.None;

    public static bool operator ==(LocalKeyword lhs, LocalKeyword rhs) => lhs.Equals(rhs);

    public static bool operator !=(LocalKeyword lhs, LocalKeyword rhs) => !lhs.Equals(rhs);

    public bool Equals(LocalKeyword rhs) => name == rhs.name && space == rhs.space;

    public override bool Equals(object? o) => o is LocalKeyword other && Equals(other);

    public override int GetHashCode() => HashCode.Combine(space, name);

    public override string ToString() => name ?? string.Empty;

    private static T Require<T>(T shader)
        where T : class => shader ?? throw new ArgumentNullException(nameof(shader), "Cannot create a LocalKeyword of a null shader.");
}
