using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
public sealed class ColorUsageAttribute : PropertyAttribute
{
    public readonly bool showAlpha = true;
    public readonly bool hdr;

    public ColorUsageAttribute(bool showAlpha) => this.showAlpha = showAlpha;

    public ColorUsageAttribute(bool showAlpha, bool hdr)
    {
        this.showAlpha = showAlpha;
        this.hdr = hdr;
    }
}
