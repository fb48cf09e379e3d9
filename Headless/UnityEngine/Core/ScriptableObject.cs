using System;
using Headless.Engine;

namespace UnityEngine;

public class ScriptableObject : Object
{
    internal bool EnableCalled { get; set; }

    public static ScriptableObject CreateInstance(string className) =>
        CreateInstance(TypeLookup.Find(className, typeof(ScriptableObject)) ?? throw new ArgumentException($"CreateInstance: no ScriptableObject class named '{className}'."));

    public static ScriptableObject CreateInstance(Type type)
    {
        ScriptableObject instance = CreateRaw(type);
        instance.SendAwake();
        return instance;
    }

    public static T CreateInstance<T>() where T : ScriptableObject => (T)CreateInstance(typeof(T));

    /// <summary>An instance that has had no messages yet; the importer fills it and calls <see cref="SendAwake"/>.</summary>
    internal static ScriptableObject CreateRaw(Type type)
    {
        if (!typeof(ScriptableObject).IsAssignableFrom(type) || type.IsAbstract)
            throw new ArgumentException($"Type does not inherit from ScriptableObject or is abstract: {type.FullName}");
        return (ScriptableObject)Activator.CreateInstance(type, nonPublic: true)!;
    }

    /// <summary>Awake, OnEnable and, in the Editor, OnValidate: what loading or creating an instance sends.</summary>
    internal void SendAwake()
    {
        if (EnableCalled) return;
        EnableCalled = true;
        ScriptType type = ScriptType.Of(GetType());
        type.Invoke(this, "Awake");
        type.Invoke(this, "OnEnable");
        if (EngineState.IsEditor) type.Invoke(this, "OnValidate");
    }

    internal override void ReleaseNative()
    {
        if (!EnableCalled) return;
        EnableCalled = false;
        ScriptType type = ScriptType.Of(GetType());
        type.Invoke(this, "OnDisable");
        type.Invoke(this, "OnDestroy");
    }

    internal override Object CloneNative()
    {
        ScriptableObject copy = CreateRaw(GetType());
        new Cloner().CopySerialized(this, copy);
        copy.SendAwake();
        return copy;
    }
}
