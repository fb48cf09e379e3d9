using System;
using System.Collections.Concurrent;

namespace UnityEngine;

/// <summary>A name as a number, the same for the same name. Files have the name.</summary>
public struct PropertyName : IEquatable<PropertyName>
{
    static readonly ConcurrentDictionary<string, int> s_Ids = new(StringComparer.Ordinal);
    static readonly ConcurrentDictionary<int, string> s_Names = new();

    readonly int m_Id;

    public PropertyName(string name) => m_Id = string.IsNullOrEmpty(name) ? 0 : s_Ids.GetOrAdd(name, Intern);
    public PropertyName(PropertyName other) => m_Id = other.m_Id;
    public PropertyName(int id) => m_Id = id;

    /// <summary>Empty where it was made from a number alone.</summary>
    internal readonly string Name => s_Names.GetValueOrDefault(m_Id, "");

    public static bool IsNullOrEmpty(PropertyName prop) => prop.m_Id == 0;

    public readonly bool Equals(PropertyName other) => m_Id == other.m_Id;
    public override readonly bool Equals(object? other) => other is PropertyName name && Equals(name);
    public override readonly int GetHashCode() => m_Id;
    public override readonly string ToString() => $"{(Name.Length > 0 ? Name : "Unknown")}:{m_Id}";
    public static bool operator ==(PropertyName lhs, PropertyName rhs) => lhs.Equals(rhs);
    public static bool operator !=(PropertyName lhs, PropertyName rhs) => !lhs.Equals(rhs);
    public static implicit operator PropertyName(string name) => new(name);
    public static implicit operator PropertyName(int id) => new(id);

    // FNV-1a, and the next free number where two names meet.
    static int Intern(string name)
    {
        uint hash = 2166136261;
        foreach (char c in name) hash = (hash ^ c) * 16777619;
        int id = (int)hash;
        while (id == 0 || s_Names.GetOrAdd(id, name) != name) id++;
        return id;
    }
}
