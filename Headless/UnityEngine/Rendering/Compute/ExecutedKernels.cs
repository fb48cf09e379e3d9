using System.Collections.Generic;
using System;
using Headless.Shaders;

namespace Headless.Engine;

/// <summary>Counts the kernel variants that were dispatched, by the compiler that made them.</summary>
internal static class ExecutedKernels
{
    private static readonly HashSet<string> direct3D = new(StringComparer.Ordinal);
    private static readonly HashSet<string> others = new(StringComparer.Ordinal);

    /// <summary>Variants that <see cref="Direct3DFrontEnd"/> made.</summary>
    public static int ByDirect3D => direct3D.Count;

    public static int ByOthers => others.Count;

    public static void Add(ShaderBinary binary) => (binary.ByDirect3D ? direct3D : others).Add(binary.Hash);
}
