using System.Collections.Generic;
using System.Linq;
using System;

namespace UnityEngine.Rendering;

public readonly struct LocalKeywordSpace : IEquatable<LocalKeywordSpace>
{
    private readonly IReadOnlyList<string>? names;

    internal LocalKeywordSpace(IReadOnlyList<string> names) => this.names = names;

    public string[] keywordNames => [.. names ?? []];

    public LocalKeyword[] keywords
    {
        get
        {
            LocalKeywordSpace space = this;
            return [.. keywordNames.Select(n => new LocalKeyword(space, n))];
        }
    }

    public uint keywordCount => (uint)(names?.Count ?? 0);

    public static bool operator ==(LocalKeywordSpace lhs, LocalKeywordSpace rhs) => lhs.Equals(rhs);

    public static bool operator !=(LocalKeywordSpace lhs, LocalKeywordSpace rhs) => !lhs.Equals(rhs);

    public LocalKeyword FindKeyword(string name) => Declares(name) ? new LocalKeyword(this, name) : default;

    public bool Equals(LocalKeywordSpace rhs) => ReferenceEquals(names, rhs.names);

    public override bool Equals(object? o) => o is LocalKeywordSpace other && Equals(other);

    public override int GetHashCode() => names?.GetHashCode() ?? 0;

    internal bool Declares(string name) => names is not null && names.Contains(name);
}
