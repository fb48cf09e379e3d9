using Headless.Shaders;
using Headless.Shaders.SpirV;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class KeywordTests : SandboxTests
{
    private const string Body = """
        RWStructuredBuffer<float> _Plain;
        #ifdef ALPHA
        RWStructuredBuffer<float> _Alpha;
        #endif
        #if BETA
        RWStructuredBuffer<float> _Beta;
        #endif
        #ifdef STRANGER
        #error STRANGER must not be defined
        #endif
        [numthreads(1, 1, 1)] void CS()
        {
            _Plain[0] = 1;
        #ifdef ALPHA
            _Alpha[0] = 1;
        #endif
        #if BETA
            _Beta[0] = 1;
        #endif
        }
        """;

    [TestCase(new string[0], new[] { "_Plain" })]
    [TestCase(new[] { "ALPHA" }, new[] { "_Plain", "_Alpha" })]
    [TestCase(new[] { "BETA", "ALPHA" }, new[] { "_Plain", "_Alpha", "_Beta" })]
    [TestCase(new[] { "STRANGER" }, new[] { "_Plain" })]
    public void VariantsOfAKernel(string[] keywords, string[] resources)
    {
        ShaderBinary binary = Sandbox.Kernel(
            "#pragma multi_compile _ ALPHA // first\n#pragma multi_compile_local __ BETA GAMMA\n" + Body, keywords);
        Assert.That(binary.Resources.Select(r => r.Name), Is.EquivalentTo(resources));
    }

    [Test]
    public void ASetWithoutEmptyOptionNeedsAKeyword()
    {
        const string source = "#pragma multi_compile ALPHA BETA\n" + Body;
        Assert.DoesNotThrow(() => Sandbox.Kernel(source, "BETA"));
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel(source));
        Assert.That(error!.Message, Does.Contain("ALPHA, BETA"));
    }

    [Test]
    public void KernelsAndTheirDefines()
    {
        string path = Sandbox.Add("Assets/K.compute", """
            #pragma kernel First;
            #pragma kernel Second SIZE=64 FAST
            #pragma require wavebasic
            #ifndef SIZE
            #define SIZE 8
            #endif
            RWStructuredBuffer<float> _Out;
            [numthreads(SIZE, 1, 1)] void First(uint i : SV_GroupIndex) { _Out[i] = 1; }
            [numthreads(SIZE, 1, 1)] void Second(uint i : SV_GroupIndex) { _Out[i] = FAST; }
            """.Replace("FAST;", "\n#ifdef FAST\nFAST\n#else\n0\n#endif\n;"));
        ComputeSource source = ComputeSource.Parse(path, Sandbox.Includes);
        Assert.That(source.Kernels.Select(k => (k.Name, k.Line)), Is.EqualTo(new[] { ("First", 1), ("Second", 2) }));
        Assert.That(source.Requires, Is.EqualTo(new[] { "wavebasic" }));
        ShaderCompiler compiler = Sandbox.Compiler();
        Assert.That(compiler.CompileKernel(source, "First", []).GroupX, Is.EqualTo(8));
        Assert.That(compiler.CompileKernel(source, "Second", []).GroupX, Is.EqualTo(64));
        var error = Assert.Throws<ShaderCompileException>(() => compiler.CompileKernel(source, "Third", []));
        Assert.That(error!.Message, Does.Contain("#pragma kernel Third"));
    }

    [Test]
    public void AKernelMayShareItsNameWithAFunction()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            RWStructuredBuffer<float2> _V;
            float2 CS(float2 a, float2 b) { return a + b; }
            [numthreads(64, 1, 1)]
            void CS (uint3 id : SV_DispatchThreadID) { _V[id.x] += CS(_V[id.x], 1); }
            """);
        Assert.That(binary.EntryPoint, Is.EqualTo("CS"));
        SpirVInstruction entry = new SpirVModule(binary.SpirV).Instructions.Single(i => i.Op == SpirVOp.EntryPoint);
        Assert.That(entry.Text(2), Is.EqualTo("CS"));
    }

    [Test]
    public void ShaderFeatureOfOneKeywordHasAnEmptyOption()
    {
        string path = Sandbox.Add("Assets/F.compute", "#pragma kernel CS\n#pragma shader_feature_local ALPHA\n");
        KeywordSet set = ComputeSource.Parse(path, Sandbox.Includes).KeywordSets.Single();
        Assert.That(set.Keywords, Is.EqualTo(new[] { "", "ALPHA" }));
        Assert.That((set.Local, set.Feature), Is.EqualTo((true, true)));
    }

    [TestCase("multi_compile")]
    [TestCase("multi_compile_wrong A")]
    public void BadKeywordPragmas(string pragma)
    {
        string path = Sandbox.Add("Assets/F.compute", $"#pragma kernel CS\n#pragma {pragma}\n");
        var error = Assert.Throws<ShaderCompileException>(() => ComputeSource.Parse(path, Sandbox.Includes));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/F.compute", 2)));
    }

    [Test]
    public void WhatUnityDefines()
    {
        Assert.DoesNotThrow(() => Sandbox.Kernel("""
            #if !SHADER_API_D3D11 || !SHADER_STAGE_COMPUTE || UNITY_VERSION < 202220 || UNITY_VERSION >= 600000 || SHADER_TARGET < 45
            #error Wrong definitions
            #endif
            #if defined(UNITY_REVERSED_Z) || defined(SHADER_STAGE_FRAGMENT)
            #error Too many definitions
            #endif
            RWStructuredBuffer<float> _Out;
            [numthreads(1, 1, 1)] void CS() { _Out[0] = 1; }
            """));
    }
}
