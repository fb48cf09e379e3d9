using System;

namespace UnityEngine;

[AttributeUsage(AttributeTargets.Field)]
public class InspectorNameAttribute : PropertyAttribute
{
    public readonly string displayName;

    public InspectorNameAttribute(string displayName) => this.displayName = displayName;
}
