using System;
using System.Collections.Generic;
using Headless.Engine;
using UnityEngine.SceneManagement;

namespace UnityEngine;

public sealed partial class GameObject : Object
{
    readonly List<Component> m_Components = new();
    readonly Transform m_Transform;
    bool m_ActiveSelf = true;
    int m_Layer;
    string m_Tag = "Untagged";

    public GameObject() : this("New Game Object") { }

    public GameObject(string name) : this(name, SceneTable.ActiveOrCreate(), true) { }

    public GameObject(string name, params Type[] components) : this(name)
    {
        foreach (Type type in components)
            if (type != typeof(Transform)) AddComponent(type);
    }

    /// <summary>scene null: a prefab asset, which never runs. joinWorld false: a loader activates it later.</summary>
    internal GameObject(string name, SceneData? scene, bool joinWorld)
    {
        NameCore = name ?? "";
        m_Transform = ObjectCreation.NewComponent<Transform>();
        m_Transform.Attach(this);
        m_Components.Add(m_Transform);
        SceneData = scene;
        scene?.AddRoot(this);
        if (joinWorld) IsActiveCached = true;
    }

    internal SceneData? SceneData { get; set; }
    internal bool IsActiveCached { get; private set; }
    internal Transform TransformCore => m_Transform;
    internal List<Component> ComponentList => m_Components;

    public GameObject gameObject => this;
    public Transform transform { get { CheckAlive(); return m_Transform; } }
    public bool activeSelf { get { CheckAlive(); return m_ActiveSelf; } }
    public bool activeInHierarchy { get { CheckAlive(); return IsActiveCached; } }
    public bool isStatic { get; set; }
    public Scene scene { get { CheckAlive(); return SceneData?.Scene ?? default; } }

    public int layer
    {
        get { CheckAlive(); return m_Layer; }
        set
        {
            CheckAlive();
            if ((uint)value > 31u)
            {
                Debug.LogError("A game object can only be in one layer. The layer needs to be in the range [0...31]", this);
                return;
            }
            m_Layer = value;
        }
    }

    public string tag
    {
        get { CheckAlive(); return m_Tag; }
        set
        {
            CheckAlive();
            if (!TagManager.IsTag(value)) throw new UnityException($"Tag: {value} is not defined.");
            m_Tag = value;
        }
    }

    public bool CompareTag(string tag)
    {
        CheckAlive();
        if (!TagManager.IsTag(tag)) throw new UnityException($"Tag: {tag} is not defined.");
        return m_Tag == tag;
    }

    internal void SetTagRaw(string tag) => m_Tag = tag;
    internal void SetActiveRaw(bool value) => m_ActiveSelf = value;

    internal override void ReleaseNative() => SceneData?.RemoveRoot(this);

    public static GameObject CreatePrimitive(PrimitiveType type) => Primitives.Create(type);

    public static GameObject Find(string name) => SceneSearch.ByPath(name)!;
    public static GameObject FindWithTag(string tag) => FindGameObjectWithTag(tag);

    public static GameObject FindGameObjectWithTag(string tag)
    {
        GameObject[] all = FindGameObjectsWithTag(tag);
        return all.Length > 0 ? all[0] : null!;
    }

    public static GameObject[] FindGameObjectsWithTag(string tag)
    {
        if (!TagManager.IsTag(tag)) throw new UnityException($"Tag: {tag} is not defined.");
        return SceneSearch.ActiveWithTag(tag);
    }
}
