using System;
using Headless.Engine;

namespace UnityEngine;

public partial class Transform
{
    public Transform parent
    {
        get { CheckAlive(); return m_Parent!; }
        set => SetParent(value, true);
    }

    public Transform root
    {
        get
        {
            CheckAlive();
            Transform t = this;
            while (t.m_Parent is not null) t = t.m_Parent;
            return t;
        }
    }

    public int childCount { get { CheckAlive(); return m_Children.Count; } }
    public int hierarchyCount => CountBelow(root);
    public int hierarchyCapacity { get => hierarchyCount; set { } }

    static int CountBelow(Transform t)
    {
        int count = 1;
        foreach (Transform child in t.m_Children) count += CountBelow(child);
        return count;
    }

    public void SetParent(Transform? p) => SetParent(p, true);

    public void SetParent(Transform? parent, bool worldPositionStays)
    {
        CheckAlive();
        if (parent is not null && !parent.IsAlive) parent = null;
        if (parent == m_Parent && parent is not null) return;
        if (parent is not null)
        {
            if (parent.IsChildOf(this)) return;
            if (parent.OwnerOrNull!.SceneData is null && OwnerOrNull!.SceneData is not null)
            {
                Debug.LogError($"Setting the parent of a transform which resides in a Prefab Asset is disabled to prevent data corruption (GameObject: '{name}').", this);
                return;
            }
        }
        Matrix4x4 world = localToWorldMatrix;
        Quaternion worldRotation = rotation;
        Relink(parent);
        if (worldPositionStays) KeepWorld(world, worldRotation);
        OwnerOrNull!.RefreshHierarchy();
        SendParentChanged();
    }

    // To the enabled scripts of this object and of all below it.
    void SendParentChanged()
    {
        if (!IsAlive) return;
        foreach (MonoBehaviour script in gameObject.GetComponents<MonoBehaviour>())
            if (script.Script.EnableCalled) script.ScriptType.Invoke(script, "OnTransformParentChanged");
        foreach (Transform child in m_Children.ToArray()) child.SendParentChanged();
    }

    /// <summary>Moves below another parent (or to the scene's roots) without touching local values or active state.</summary>
    internal void Relink(Transform? parent)
    {
        GameObject owner = OwnerOrNull!;
        if (m_Parent is null) owner.SceneData?.RemoveRoot(owner);
        else m_Parent.m_Children.Remove(this);
        m_Parent = parent;
        if (parent is null)
        {
            owner.SceneData?.AddRoot(owner);
        }
        else
        {
            parent.m_Children.Add(this);
            SceneData? scene = parent.OwnerOrNull!.SceneData;
            if (owner.SceneData != scene) SceneTable.Assign(owner, scene);
        }
        Invalidate();
    }

    void KeepWorld(Matrix4x4 world, Quaternion worldRotation)
    {
        position = world.GetPosition();
        rotation = worldRotation;
        m_LocalScale = Vector3.one;
        Invalidate();
        Matrix4x4 scale = localToWorldMatrix.inverse * world;
        if (!scale.Equals(Matrix4x4.zero)) localScale = new Vector3(scale.m00, scale.m11, scale.m22);
    }

    public void DetachChildren()
    {
        foreach (Transform child in ChildrenSnapshot()) child.SetParent(null, true);
    }

    public Transform GetChild(int index)
    {
        CheckAlive();
        if ((uint)index >= (uint)m_Children.Count) throw new UnityException("Transform child out of bounds");
        return m_Children[index];
    }

    public bool IsChildOf(Transform parent)
    {
        ArgumentNullException.ThrowIfNull(parent);
        for (Transform? t = this; t is not null; t = t.m_Parent)
            if (ReferenceEquals(t, parent)) return true;
        return false;
    }

    public Transform Find(string n)
    {
        CheckAlive();
        ArgumentNullException.ThrowIfNull(n);
        Transform? current = this;
        foreach (string part in n.Split('/'))
        {
            if (part.Length == 0) continue;
            current = part == ".." ? current.m_Parent : current.ChildNamed(part);
            if (current is null) return null!;
        }
        return n.Length == 0 ? null! : current;
    }

    Transform? ChildNamed(string childName)
    {
        foreach (Transform child in m_Children)
            if (child.NameCore == childName) return child;
        return null;
    }

    public int GetSiblingIndex()
    {
        CheckAlive();
        return m_Parent is null ? OwnerOrNull!.SceneData?.Roots.IndexOf(OwnerOrNull!) ?? 0 : m_Parent.m_Children.IndexOf(this);
    }

    public void SetAsFirstSibling() => SetSiblingIndex(0);
    public void SetAsLastSibling() => SetSiblingIndex(int.MaxValue);

    public void SetSiblingIndex(int index)
    {
        CheckAlive();
        if (m_Parent is null)
        {
            if (OwnerOrNull!.SceneData?.Roots is not { } roots) return;
            roots.Remove(OwnerOrNull!);
            roots.Insert(Math.Clamp(index, 0, roots.Count), OwnerOrNull!);
            return;
        }
        m_Parent.m_Children.Remove(this);
        m_Parent.m_Children.Insert(Math.Clamp(index, 0, m_Parent.m_Children.Count), this);
    }

    internal void DetachFromParent()
    {
        m_Parent?.m_Children.Remove(this);
        m_Parent = null;
    }
}
