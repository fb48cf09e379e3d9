using System;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine;

public partial class Component : Object
{
    GameObject? m_GameObject;

    /// <summary>True while the component takes part in the running scene: active GameObject, enabled.</summary>
    internal bool IsAdded { get; private set; }

    public GameObject gameObject
    {
        get { CheckAlive(); return m_GameObject!; }
    }

    public Transform transform
    {
        get { CheckAlive(); return m_GameObject!.TransformCore; }
    }

    public string tag { get => gameObject.tag; set => gameObject.tag = value; }

    internal GameObject? OwnerOrNull => m_GameObject;
    internal override string NameCore { get => m_GameObject?.NameCore ?? base.NameCore; set { if (m_GameObject is null) base.NameCore = value; else m_GameObject.NameCore = value; } }

    internal void Attach(GameObject owner) => m_GameObject = owner;

    public bool CompareTag(string tag) => gameObject.CompareTag(tag);

    /// <summary>The component's own switch; types with an enabled property override it.</summary>
    internal virtual bool EnabledSelf => true;

    /// <summary>Called when the GameObject becomes active for the first time or again.</summary>
    internal virtual void AwakeFromLoad() => RefreshActivation();

    /// <summary>Adds to or removes from the running scene, whatever active state and enabled flag ask for.</summary>
    internal void RefreshActivation()
    {
        bool requested = IsAlive && m_GameObject is { } owner && owner.IsActiveCached && EnabledSelf;
        if (requested == IsAdded) return;
        IsAdded = requested;
        if (requested) OnAdded();
        else OnRemoved();
    }

    internal void RemoveFromScene()
    {
        if (!IsAdded) return;
        IsAdded = false;
        OnRemoved();
    }

    /// <summary>Sizes a new component after what its object already has, e.g. a collider after the mesh.</summary>
    internal virtual void FitToMesh() { }

    internal virtual void OnAdded() { }
    internal virtual void OnRemoved() { }

    /// <summary>The GameObject was switched off, whether or not the component was enabled.</summary>
    internal virtual void OnDeactivated() => RemoveFromScene();

    /// <summary>Last call before the component dies.</summary>
    internal virtual void OnDestroying() { }

    /// <summary>Copies what the type keeps beyond serialised script fields; see <see cref="Cloner"/>.</summary>
    internal virtual void CopyNativeState(Component source, Cloner cloner) => cloner.CopyEngineFields(source, this);
}
