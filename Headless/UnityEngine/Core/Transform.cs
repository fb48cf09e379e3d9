using System.Collections;
using System.Collections.Generic;
using Headless.Engine;

namespace UnityEngine;

public partial class Transform : Component, IEnumerable
{
    readonly List<Transform> m_Children = new();
    Transform? m_Parent;
    Vector3 m_LocalPosition;
    Quaternion m_LocalRotation = Quaternion.identity;
    Vector3 m_LocalScale = Vector3.one;
    Matrix4x4 m_LocalToWorld;
    bool m_WorldValid;
    bool m_HasChanged = true;

    protected Transform() { }

    internal Transform? ParentCore => m_Parent;
    internal Transform[] ChildrenSnapshot() => m_Children.ToArray();
    internal List<Transform> ChildList => m_Children;

    public Vector3 localPosition { get { CheckAlive(); return m_LocalPosition; } set { CheckAlive(); m_LocalPosition = value; Invalidate(); } }
    public Quaternion localRotation { get { CheckAlive(); return m_LocalRotation; } set { CheckAlive(); m_LocalRotation = value; Invalidate(); } }
    public Vector3 localScale { get { CheckAlive(); return m_LocalScale; } set { CheckAlive(); m_LocalScale = value; Invalidate(); } }
    public Vector3 localEulerAngles { get => localRotation.eulerAngles; set => localRotation = Quaternion.Euler(value); }
    public bool hasChanged { get { CheckAlive(); return m_HasChanged; } set { CheckAlive(); m_HasChanged = value; } }

    public Vector3 position
    {
        get => localToWorldMatrix.GetPosition();
        set => localPosition = m_Parent is null ? value : m_Parent.InverseTransformPoint(value);
    }

    public Quaternion rotation
    {
        get { CheckAlive(); return ToWorldRotation(Quaternion.identity); }
        set => localRotation = m_Parent is null ? Quaternion.Normalize(value) : Quaternion.Normalize(m_Parent.ToLocalRotation(value));
    }

    public Vector3 eulerAngles { get => rotation.eulerAngles; set => rotation = Quaternion.Euler(value); }

    public Vector3 lossyScale
    {
        get
        {
            Matrix4x4 unrotated = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * localToWorldMatrix;
            return new Vector3(unrotated.m00, unrotated.m11, unrotated.m22);
        }
    }

    public Vector3 right { get => rotation * Vector3.right; set => rotation = Quaternion.FromToRotation(Vector3.right, value); }
    public Vector3 up { get => rotation * Vector3.up; set => rotation = Quaternion.FromToRotation(Vector3.up, value); }
    public Vector3 forward { get => rotation * Vector3.forward; set => rotation = Quaternion.LookRotation(value); }

    public Matrix4x4 localToWorldMatrix
    {
        get
        {
            CheckAlive();
            if (!m_WorldValid)
            {
                Matrix4x4 local = Matrix4x4.TRS(m_LocalPosition, m_LocalRotation, m_LocalScale);
                m_LocalToWorld = m_Parent is null ? local : m_Parent.localToWorldMatrix * local;
                m_WorldValid = true;
            }
            return m_LocalToWorld;
        }
    }

    public Matrix4x4 worldToLocalMatrix => localToWorldMatrix.inverse;

    public void GetPositionAndRotation(out Vector3 position, out Quaternion rotation) { position = this.position; rotation = this.rotation; }
    public void GetLocalPositionAndRotation(out Vector3 localPosition, out Quaternion localRotation) { localPosition = this.localPosition; localRotation = this.localRotation; }
    public void SetPositionAndRotation(Vector3 position, Quaternion rotation) { this.position = position; this.rotation = rotation; }

    public void SetLocalPositionAndRotation(Vector3 localPosition, Quaternion localRotation)
    {
        CheckAlive();
        m_LocalPosition = localPosition;
        m_LocalRotation = localRotation;
        Invalidate();
    }

    internal void SetLocalRaw(Vector3 position, Quaternion rotation, Vector3 scale)
    {
        m_LocalPosition = position;
        m_LocalRotation = rotation;
        m_LocalScale = scale;
        Invalidate();
    }

    internal void Invalidate()
    {
        m_HasChanged = true;
        if (!m_WorldValid && m_Children.Count == 0) return;
        m_WorldValid = false;
        foreach (Transform child in m_Children) child.Invalidate();
    }

    Quaternion ToWorldRotation(Quaternion inner)
    {
        Quaternion q = m_LocalRotation * inner;
        for (Transform? t = m_Parent; t is not null; t = t.m_Parent) q = t.m_LocalRotation * Mirror(q, t.m_LocalScale);
        return q;
    }

    Quaternion ToLocalRotation(Quaternion world)
    {
        if (m_Parent is not null) world = m_Parent.ToLocalRotation(world);
        return Mirror(Quaternion.Inverse(m_LocalRotation) * world, m_LocalScale);
    }

    // A rotation axis is a pseudovector: under diag(sx, sy, sz) it becomes (sy sz, sx sz, sx sy) times itself.
    static Quaternion Mirror(Quaternion q, Vector3 scale)
    {
        float sx = Mathf.Sign(scale.x), sy = Mathf.Sign(scale.y), sz = Mathf.Sign(scale.z);
        return new Quaternion(q.x * sy * sz, q.y * sx * sz, q.z * sx * sy, q.w);
    }

    internal override void CopyNativeState(Component source, Cloner cloner)
    {
        var other = (Transform)source;
        SetLocalRaw(other.m_LocalPosition, other.m_LocalRotation, other.m_LocalScale);
    }

    public IEnumerator GetEnumerator() => new ChildEnumerator(this);

    sealed class ChildEnumerator(Transform outer) : IEnumerator
    {
        int m_Index = -1;

        public object Current => outer.GetChild(m_Index);
        public bool MoveNext() => ++m_Index < outer.childCount;
        public void Reset() => m_Index = -1;
    }
}
