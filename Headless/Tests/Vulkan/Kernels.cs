using NUnit.Framework;
using System.Runtime.InteropServices;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Tests.Vulkan;

/// <summary>The kernels that the compute tests share.</summary>
internal static class Kernels
{
    public const int GroupSize = 64;

    private const string Header = """
        [[vk::binding(0, 0)]] cbuffer Constants { uint _Count; uint _Value; };
        [[vk::binding(1, 0)]] RWStructuredBuffer<uint> _Target;
        [[vk::binding(2, 0)]] StructuredBuffer<uint> _Source;

        """;

    /// <summary>_Target[i] = _Value + i.</summary>
    public static ShaderBinary Fill { get; } = TestShader.Kernel("Fill", GroupSize, Header + """
        [numthreads(64, 1, 1)] void Fill(uint3 id : SV_DispatchThreadID)
        {
            if (id.x < _Count) { _Target[id.x] = _Value + id.x; }
        }
        """, TestShader.Uniform(0, 16), TestShader.Write(1, "_Target"));

    /// <summary>_Target[i] += _Source[i] + _Value.</summary>
    public static ShaderBinary Add { get; } = TestShader.Kernel("Add", GroupSize, Header + """
        [numthreads(64, 1, 1)] void Add(uint3 id : SV_DispatchThreadID)
        {
            if (id.x < _Count) { _Target[id.x] += _Source[id.x] + _Value; }
        }
        """, TestShader.Uniform(0, 16), TestShader.Write(1, "_Target"), TestShader.Read(2, "_Source"));

    /// <summary>_Target[i] = _Source[count - 1 - i] + _Value: reads what another group wrote.</summary>
    public static ShaderBinary Reverse { get; } = TestShader.Kernel("Reverse", GroupSize, Header + """
        [numthreads(64, 1, 1)] void Reverse(uint3 id : SV_DispatchThreadID)
        {
            if (id.x < _Count) { _Target[id.x] = _Source[_Count - 1 - id.x] + _Value; }
        }
        """, TestShader.Uniform(0, 16), TestShader.Write(1, "_Target"), TestShader.Read(2, "_Source"));

    /// <summary>Writes the groups that _Value threads need.</summary>
    public static ShaderBinary Arguments { get; } = TestShader.Kernel("Arguments", 1, Header + """
        [numthreads(1, 1, 1)] void Arguments()
        {
            _Target[0] = (_Value + 63) / 64;
            _Target[1] = 1;
            _Target[2] = 1;
        }
        """, TestShader.Uniform(0, 16), TestShader.Write(1, "_Target"));

    public static ResourceBindings Bind(uint count, uint value, GpuBuffer target, GpuBuffer? source = null)
    {
        ResourceBindings bindings = new();
        SetConstants(bindings, count, value);
        bindings.SetBuffer(0, 1, target);
        if (source is not null)
        {
            bindings.SetBuffer(0, 2, source);
        }

        return bindings;
    }

    public static void SetConstants(ResourceBindings bindings, uint count, uint value) =>
        bindings.SetUniform(0, 0, MemoryMarshal.AsBytes<uint>([count, value]));

    public static uint Groups(long count) => (uint)((count + GroupSize - 1) / GroupSize);
}
