using System;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace Headless.Engine;

/// <summary>What a body is given: numbers that are not finite are refused with Unity's message, and the body keeps what it had.</summary>
static class RigidbodyInput
{
    public static bool Refuses(Rigidbody body, string name, Vector3 value) => Refuses(body, name, [value.x, value.y, value.z]);

    public static bool Refuses(Rigidbody body, string name, Quaternion value) => Refuses(body, name, [value.x, value.y, value.z, value.w]);

    public static bool Refuses(Rigidbody body, string name, params ReadOnlySpan<float> value)
    {
        bool isFinite = true;
        foreach (float number in value) isFinite &= float.IsFinite(number);
        if (isFinite) return false;
        string numbers = string.Join(", ", value.ToArray().Select(v => v.ToString("F6", CultureInfo.InvariantCulture)));
        Debug.LogError($"rigidbody.{name} assign attempt for '{body.name}' is not valid. Input {name} is {{ {numbers} }}.", body);
        return true;
    }
}
