using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

/// <summary>Points p with dot(normal, p) + distance = 0. Three clockwise points face the viewer (left-handed).</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Plane : IFormattable
{
    Vector3 m_Normal;
    float m_Distance;

    public Plane(Vector3 inNormal, Vector3 inPoint)
    {
        m_Normal = Vector3.Normalize(inNormal);
        m_Distance = -Vector3.Dot(m_Normal, inPoint);
    }

    public Plane(Vector3 inNormal, float d)
    {
        m_Normal = Vector3.Normalize(inNormal);
        m_Distance = d;
    }

    public Plane(Vector3 a, Vector3 b, Vector3 c) : this(Vector3.Cross(b - a, c - a), a) { }

    public Vector3 normal { readonly get => m_Normal; set => m_Normal = value; }
    public float distance { readonly get => m_Distance; set => m_Distance = value; }
    public Plane flipped => new() { m_Normal = -m_Normal, m_Distance = -m_Distance };

    public void SetNormalAndPosition(Vector3 inNormal, Vector3 inPoint) => this = new Plane(inNormal, inPoint);
    public void Set3Points(Vector3 a, Vector3 b, Vector3 c) => this = new Plane(a, b, c);
    public void Flip() => this = flipped;
    public void Translate(Vector3 translation) => m_Distance += Vector3.Dot(m_Normal, translation);
    public static Plane Translate(Plane plane, Vector3 translation) { plane.Translate(translation); return plane; }

    public Vector3 ClosestPointOnPlane(Vector3 point) => point - m_Normal * GetDistanceToPoint(point);
    public float GetDistanceToPoint(Vector3 point) => Vector3.Dot(m_Normal, point) + m_Distance;
    public bool GetSide(Vector3 point) => GetDistanceToPoint(point) > 0f;
    public bool SameSide(Vector3 inPt0, Vector3 inPt1) => GetSide(inPt0) == GetSide(inPt1);

    public bool Raycast(Ray ray, out float enter)
    {
        float slope = Vector3.Dot(ray.direction, m_Normal);
        if (Mathf.Approximately(slope, 0f))
        {
            enter = 0f;
            return false;
        }
        enter = -GetDistanceToPoint(ray.origin) / slope;
        return enter > 0f;
    }

    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"(normal:{m_Normal.ToString(format, formatProvider)}, distance:{m_Distance.ToString(string.IsNullOrEmpty(format) ? "F2" : format, formatProvider ?? System.Globalization.CultureInfo.InvariantCulture)})";
}
