using System.Collections.Generic;
using System.IO;
using System.Linq;
using System;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Engine;

/// <summary>The compiled side of a ComputeShader: kernels, state and keywords.</summary>
internal sealed class ComputeProgram
{
    private readonly ComputeKernel[] kernels;
    private readonly Dictionary<string, int> kernelIndices = new(StringComparer.Ordinal);
    private readonly KeywordSelection selection;
    private string[] active = [];
    private string activeKey = string.Empty;
    private int selectedLocal = -1;
    private int selectedGlobal = -1;

    public ComputeProgram(ComputeSource source)
    {
        Source = source;
        kernels = [.. source.Kernels.Select(k => new ComputeKernel(k))];
        for (int i = 0; i < kernels.Length; i++)
        {
            kernelIndices.TryAdd(kernels[i].Name, i);
        }

        selection = new KeywordSelection(source.KeywordSets);
    }

    public ComputeSource Source { get; }
    public ComputeState State { get; } = new();
    public KeywordState Keywords { get; } = new();
    public IReadOnlyList<string> KeywordNames => selection.Names;
    public int KernelCount => kernels.Length;
    public string Label => Path.GetFileNameWithoutExtension(Source.Path);

    public int Find(string kernel) => kernelIndices.TryGetValue(kernel, out int index) ? index : -1;

    /// <summary>The kernel; null after an error in the console for an index that is none.</summary>
    public ComputeKernel? Kernel(int index)
    {
        if ((uint)index < (uint)kernels.Length)
        {
            return kernels[index];
        }

        Debug.LogError($"Kernel index ({index}) out of range in compute shader '{Label}', which has {kernels.Length} kernels");
        return null;
    }

    /// <summary>The variant for the current keywords; null when it does not compile, which is said once.</summary>
    public ComputeVariant? Variant(ComputeKernel kernel)
    {
        SelectKeywords();
        if (kernel.TryGet(activeKey, out ComputeVariant? variant))
        {
            return variant;
        }

        try
        {
            ShaderBinary binary = GraphicsDevice.Compiler.CompileKernel(Source, kernel.Name, active);
            variant = new ComputeVariant(binary, State, $"{Source.Path}|{kernel.Name}|{activeKey}");
        }
        catch (ShaderCompileException problem)
        {
            Debug.LogError(problem.Message);
        }
        catch (ShaderCompilerMissingException problem)
        {
            (EngineHooks.CompilerMissing ?? Debug.LogError)(problem.Message);
        }

        kernel.Add(activeKey, variant);
        return variant;
    }

    public void CopyStateFrom(ComputeProgram other)
    {
        State.CopyFrom(other.State);
        Keywords.Replace(other.Keywords.Enabled);
    }

    private void SelectKeywords()
    {
        if (selectedLocal == Keywords.Version && selectedGlobal == GlobalKeywords.Version)
        {
            return;
        }

        selectedLocal = Keywords.Version;
        selectedGlobal = GlobalKeywords.Version;
        active = selection.Select(Keywords.Set);
        activeKey = string.Join(' ', active);
    }
}
