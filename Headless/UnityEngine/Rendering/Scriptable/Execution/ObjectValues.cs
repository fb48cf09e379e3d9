using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Variables that shaders read of the object that is drawn.</summary>
internal static class ObjectValues
{
    private const int MaxLights = 8;

    private static readonly Vector4[] Indices = new Vector4[2];

    public static void Apply(DrawRequest draw, PerObjectData data, CulledLights lights, int mainLight)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetVector(BuiltinNames.RenderingLayer, new Vector4(BitConverter.UInt32BitsToSingle(draw.RenderingLayers), 0f, 0f, 0f));
        if ((data & PerObjectData.ReflectionProbes) != 0)
        {
            ReflectionSettings.Apply(draw.Reflections, draw.Bounds);
        }

        if ((data & (PerObjectData.LightData | PerObjectData.LightIndices)) != 0)
        {
            ApplyLights(lights.Of(draw), mainLight < 0 || lights.Reaches(mainLight, draw));
        }
    }

    /// <summary>For draws that are no objects.</summary>
    public static void Clear()
    {
        GlobalProperties.Sheet.SetVector(BuiltinNames.RenderingLayer, default);
        ApplyLights([], true);
    }

    /// <summary>y is the number of lights, z whether the main light shines on the object.</summary>
    private static void ApplyLights(List<int> numbers, bool main)
    {
        PropertySheet sheet = GlobalProperties.Sheet;
        int count = Math.Min(numbers.Count, MaxLights);
        Indices.AsSpan().Clear();
        for (int i = 0; i < count; i++)
        {
            Indices[i / 4][i % 4] = numbers[i];
        }

        sheet.SetVector(BuiltinNames.LightData, new Vector4(0f, count, main ? 1f : 0f, 0f));
        sheet.SetVectors(BuiltinNames.LightIndices, Indices);
    }
}
