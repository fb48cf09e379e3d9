using System;
using Headless.Engine;

namespace UnityEngine;

/// <summary>Base of everything the engine counts. A destroyed object stays a managed reference that compares equal to null.</summary>
public partial class Object
{
    int m_InstanceID;
    bool m_Alive;
    string m_Name = "";
    HideFlags m_HideFlags;

    public Object()
    {
        if (!ObjectCreation.Allows(this)) return;
        m_Alive = true;
        m_InstanceID = ObjectRegistry.Register(this);
    }

    internal bool IsAlive => m_Alive;

    /// <summary>Loaded from a file of the project: destroying it needs allowDestroyingAssets, as in the Editor.</summary>
    internal bool IsPersistent { get; set; }

    public string name
    {
        get { CheckAlive(); return NameCore; }
        set { CheckAlive(); NameCore = value ?? ""; }
    }

    internal virtual string NameCore { get => m_Name; set => m_Name = value; }

    public HideFlags hideFlags
    {
        get { CheckAlive(); return m_HideFlags; }
        set { CheckAlive(); m_HideFlags = value; }
    }

    public int GetInstanceID() => m_InstanceID;
    public override int GetHashCode() => m_InstanceID;

    public override bool Equals(object? other)
    {
        var otherObject = other as Object;
        if (otherObject is null && other is not null) return false;
        return Same(this, otherObject);
    }

    public override string ToString() => m_Alive ? $"{NameCore} ({GetType().FullName})" : "null";

    public static implicit operator bool(Object? exists) => exists is not null && exists.m_Alive;
    public static bool operator ==(Object? x, Object? y) => Same(x, y);
    public static bool operator !=(Object? x, Object? y) => !Same(x, y);

    static bool Same(Object? a, Object? b)
    {
        if (b is null) return a is null || !a.m_Alive;
        if (a is null) return !b.m_Alive;
        return ReferenceEquals(a, b);
    }

    internal void CheckAlive()
    {
        if (m_Alive) return;
        throw new MissingReferenceException(
            $"The object of type '{GetType().Name}' has been destroyed but you are still trying to access it.\n" +
            "Your script should either check if it is null or you should not destroy the object.");
    }

    /// <summary>Ends the native life: the registry forgets the object and derived types free what they hold.</summary>
    internal void Kill()
    {
        if (!m_Alive) return;
        ReleaseNative();
        m_Alive = false;
        ObjectRegistry.Unregister(m_InstanceID);
    }

    /// <summary>Frees device or native memory; called once, while the object still counts as alive.</summary>
    internal virtual void ReleaseNative() { }

    /// <summary>A copy for Instantiate; types with native content override it.</summary>
    internal virtual Object CloneNative() =>
        throw new ArgumentException($"Instantiate: an object of type {GetType().Name} cannot be copied.");
}
