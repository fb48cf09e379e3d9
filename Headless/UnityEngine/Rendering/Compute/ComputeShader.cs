using System.Linq;
using System;
using Headless.Engine;
using Headless.Shaders;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class ComputeShader : Object
{
    internal ComputeShader(ComputeSource source)
    {
        Program = new ComputeProgram(source);
        name = Program.Label;
    }

    private ComputeShader(ComputeShader source)
        : this(source.Program.Source)
    {
        name = source.name;
        Program.CopyStateFrom(source.Program);
    }

    public LocalKeywordSpace keywordSpace => new(Program.KeywordNames);

    public string[] shaderKeywords
    {
        get => [.. Program.Keywords.Enabled];
        set => Program.Keywords.Replace(value ?? []);
    }

    public LocalKeyword[] enabledKeywords
    {
        get
        {
            LocalKeywordSpace space = keywordSpace;
            return [.. Program.Keywords.Enabled.Where(space.Declares).Select(k => new LocalKeyword(space, k))];
        }
        set => Program.Keywords.Replace((value ?? []).Select(k => k.name));
    }

    internal ComputeProgram Program { get; private set; }

    /// <summary>The file has changed: the same object, its kernels made anew, nothing bound.</summary>
    internal void Reimport(ComputeSource source) => Program = new ComputeProgram(source);

    public int FindKernel(string name)
    {
        ArgumentNullException.ThrowIfNull(name);
        int index = Program.Find(name);
        if (index < 0)
        {
            throw new ArgumentException($"Kernel '{name}' not found in compute shader '{this.name}'.", nameof(name));
        }

        return index;
    }

    public bool HasKernel(string name) => Program.Find(name) >= 0;

    public bool IsSupported(int kernelIndex) =>
        Program.Kernel(kernelIndex) is { } kernel && Program.Variant(kernel) is { Unsupported: null };

    public void GetKernelThreadGroupSizes(int kernelIndex, out uint x, out uint y, out uint z)
    {
        (x, y, z) = (0, 0, 0);
        if (Program.Kernel(kernelIndex) is not { } kernel)
        {
            return;
        }

        if (Program.Variant(kernel) is not { } variant)
        {
            Debug.LogError($"Compute shader ({name}): kernel at index ({kernelIndex}) '{kernel.Name}' is invalid");
            return;
        }

        (x, y, z) = ((uint)variant.Binary.GroupX, (uint)variant.Binary.GroupY, (uint)variant.Binary.GroupZ);
    }

    public void EnableKeyword(string keyword) => Program.Keywords.Change(keyword, true);

    public void EnableKeyword(in LocalKeyword keyword) => Program.Keywords.Change(keyword.name, true);

    public void DisableKeyword(string keyword) => Program.Keywords.Change(keyword, false);

    public void DisableKeyword(in LocalKeyword keyword) => Program.Keywords.Change(keyword.name, false);

    public void SetKeyword(in LocalKeyword keyword, bool value) => Program.Keywords.Change(keyword.name, value);

    public bool IsKeywordEnabled(string keyword) => Program.Keywords.IsEnabled(keyword);

    public bool IsKeywordEnabled(in LocalKeyword keyword) => Program.Keywords.IsEnabled(keyword.name);

    public void Dispatch(int kernelIndex, int threadGroupsX, int threadGroupsY, int threadGroupsZ) =>
        ComputeDispatcher.Dispatch(this, kernelIndex, threadGroupsX, threadGroupsY, threadGroupsZ);

    public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer) => DispatchIndirect(kernelIndex, argsBuffer, 0u);

    public void DispatchIndirect(int kernelIndex, ComputeBuffer argsBuffer, uint argsOffset) =>
        ComputeDispatcher.DispatchIndirect(this, kernelIndex, argsBuffer?.Storage, argsOffset);

    public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer) => DispatchIndirect(kernelIndex, argsBuffer, 0u);

    public void DispatchIndirect(int kernelIndex, GraphicsBuffer argsBuffer, uint argsOffset) =>
        ComputeDispatcher.DispatchIndirect(this, kernelIndex, argsBuffer?.Storage, argsOffset);

    internal override Object CloneNative() => new ComputeShader(this);
}
