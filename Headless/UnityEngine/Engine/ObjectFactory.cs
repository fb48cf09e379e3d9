using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>How loaders build scenes and prefabs: objects first, without messages; then one activation.</summary>
static class ObjectFactory
{
    /// <summary>scene null makes a prefab asset.</summary>
    public static GameObject CreateGameObject(string name, SceneData? scene) => new(name, scene, joinWorld: false) { IsPersistent = scene is null };

    public static Component AddComponent(GameObject owner, Type type)
    {
        Component component = owner.AddComponentRaw(type);
        component.IsPersistent = owner.IsPersistent;
        return component;
    }

    /// <summary>Appends to the parent's children, keeping local values; null makes it a root again.</summary>
    public static void SetParent(Transform child, Transform? parent) => child.Relink(parent);

    public static void SetLocal(Transform transform, Vector3 position, Quaternion rotation, Vector3 scale) => transform.SetLocalRaw(position, rotation, scale);

    public static void SetHeader(GameObject owner, bool active, int layer, string tag)
    {
        owner.SetActiveRaw(active);
        owner.layer = layer;
        owner.SetTagRaw(tag);
    }

    public static void SetEnabled(Behaviour behaviour, bool enabled) => behaviour.SetEnabledRaw(enabled);

    /// <summary>Marks a loaded asset, which Destroy then refuses.</summary>
    public static void MarkPersistent(UnityEngine.Object asset) => asset.IsPersistent = true;

    /// <summary>Wakes all objects of a scene: OnValidate (Editor only), then Awake and OnEnable by execution order.</summary>
    public static void Activate(SceneData scene)
    {
        scene.IsLoaded = true;
        Activate(scene.Roots);
    }

    public static void Activate(IReadOnlyList<GameObject> roots)
    {
        var queue = new AwakeQueue();
        var copy = new List<GameObject>(roots);
        if (EngineState.IsEditor)
            foreach (GameObject root in copy) Validate(root);
        foreach (GameObject root in copy)
        {
            Transform? parent = root.TransformCore.ParentCore;
            if (parent is null || parent.OwnerOrNull!.IsActiveCached) root.CollectActivated(queue);
        }
        queue.Run();
    }

    static void Validate(GameObject gameObject)
    {
        foreach (Component component in gameObject.ComponentList.ToArray())
            if (component is MonoBehaviour script) script.ScriptType.Invoke(script, "OnValidate");
        foreach (Transform child in gameObject.TransformCore.ChildrenSnapshot()) Validate(child.OwnerOrNull!);
    }
}
