using System;
using System.Runtime.InteropServices;

namespace UnityEngine;

[StructLayout(LayoutKind.Sequential)]
public struct Ray : IFormattable
{
    Vector3 m_Origin;
    Vector3 m_Direction;

    public Ray(Vector3 origin, Vector3 direction) { m_Origin = origin; m_Direction = direction.normalized; }

    public Vector3 origin { readonly get => m_Origin; set => m_Origin = value; }
    public Vector3 direction { readonly get => m_Direction; set => m_Direction = value.normalized; }

    public Vector3 GetPoint(float distance) => m_Origin + m_Direction * distance;

    public override readonly string ToString() => ToString(null, null);
    public readonly string ToString(string? format) => ToString(format, null);
    public readonly string ToString(string? format, IFormatProvider? formatProvider) =>
        $"Origin: {m_Origin.ToString(format, formatProvider)}, Dir: {m_Direction.ToString(format, formatProvider)}";
}
