using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class CacheTests : SandboxTests
{
    private const string NoCompiler = "no-such-compiler";

    private const string Source = """
        #pragma kernel A
        #pragma kernel B
        #include "Value.hlsl"
        float4x4 _M; RWTexture2D<float4> _T; RWStructuredBuffer<float> _Out;
        [numthreads(4, 2, 1)] void A(uint3 id : SV_DispatchThreadID) { _Out[id.x] = Value() * _M[1][2]; _T[id.xy] = 1; }
        [numthreads(1, 1, 1)] void B() { _Out[0] = Value(); }
        """;

    private string path = "";

    [SetUp]
    public void AddSource()
    {
        Sandbox.Add("Assets/Value.hlsl", "float Value() { return 1; }\n");
        path = Sandbox.Add("Assets/Cached.compute", Source);
    }

    private ComputeSource Parse() => ComputeSource.Parse(path, Sandbox.Includes);

    [Test]
    public void ASecondCompilerNeedsNoProgram()
    {
        ShaderBinary made = Sandbox.Compiler().CompileKernel(Parse(), "A", []);
        ShaderCompiler second = Sandbox.Compiler(NoCompiler);
        ShaderBinary read = second.CompileKernel(Parse(), "A", []);
        Assert.That(second.Compilations, Is.Zero);
        Assert.That(read.SpirV, Is.EqualTo(made.SpirV));
        Assert.That((read.Hash, read.GroupX, read.GroupY, read.EntryPoint), Is.EqualTo((made.Hash, 4, 2, "A")));
        Assert.That(read.Resources.Select(r => r with { Members = [] }), Is.EqualTo(made.Resources.Select(r => r with { Members = [] })));
        Assert.That(Resource(read, "$Globals").Members, Is.EqualTo(Resource(made, "$Globals").Members));
    }

    [Test]
    public void PassesAreCachedToo()
    {
        const string hlsl = """
            #pragma vertex vert
            #pragma fragment frag
            float4 vert(float4 p : POSITION) : SV_Position { return p; }
            float4 frag() : SV_Target { return 1; }
            """;
        IReadOnlyList<ShaderBinary> made = Sandbox.Pass(hlsl);
        ShaderLabSource source = ShaderLabSource.Parse(Path.Combine(Sandbox.Root, "Assets/Test.shader"), Sandbox.Includes);
        IReadOnlyList<ShaderBinary> read = Sandbox.Compiler(NoCompiler).CompilePass(source.SubShaders[0].Passes[0], []);
        Assert.That(read.Select(b => b.Hash), Is.EqualTo(made.Select(b => b.Hash)));
        Assert.That(read[0].Inputs, Is.EqualTo(made[0].Inputs));
    }

    [Test]
    public void NeitherCacheNorCompilerIsANamedErrorWithTheCure()
    {
        var error = Assert.Throws<ShaderCompilerMissingException>(
            () => Sandbox.Compiler(NoCompiler).CompileKernel(Parse(), "A", []));
        Assert.That(error!.Message, Does.Contain("kernel 'A' of 'Assets/Cached.compute'").And.Contain("glslang-tools"));
    }

    [Test]
    public void AnIncludeCounts()
    {
        Sandbox.Compiler().CompileKernel(Parse(), "A", []);
        Sandbox.Add("Assets/Value.hlsl", "float Value() { return 2; }\n");
        ShaderCompiler second = Sandbox.Compiler();
        second.CompileKernel(Parse(), "A", []);
        Assert.That(second.Compilations, Is.EqualTo(1));
    }

    [Test]
    public void DamagedFilesAreMadeAgain()
    {
        Sandbox.Compiler().CompileKernel(Parse(), "A", []);
        string file = Directory.GetFiles(Sandbox.Cache, "*.shader", SearchOption.AllDirectories).Single();
        byte[] bytes = File.ReadAllBytes(file);
        foreach (byte[] damaged in new[] { bytes[..(bytes.Length / 2)], [], [.. bytes[..^8], 1, 2, 3, 4, 5, 6, 7, 8] })
        {
            File.WriteAllBytes(file, damaged);
            ShaderCompiler again = Sandbox.Compiler();
            again.CompileKernel(Parse(), "A", []);
            Assert.That(again.Compilations, Is.EqualTo(1));
            Assert.That(File.ReadAllBytes(file), Is.EqualTo(bytes));
        }
    }

    [Test]
    public void PrewarmCompilesEverythingAndReportsTheFirstFailure()
    {
        ComputeSource source = Parse();
        ShaderCompiler compiler = Sandbox.Compiler();
        compiler.Prewarm([new ShaderRequest(source, "A", []), new ShaderRequest(source, "B", [])]);
        Assert.That(compiler.Compilations, Is.EqualTo(2));
        compiler.CompileKernel(source, "B", []);
        Assert.That(compiler.Compilations, Is.EqualTo(2));
        ShaderCompiler other = Sandbox.Compiler();
        var error = Assert.Throws<ShaderCompileException>(
            () => other.Prewarm([new ShaderRequest(source, "Nothing", []), new ShaderRequest(source, "A", [])]));
        Assert.That(error!.Message, Does.Contain("Nothing"));
        Assert.DoesNotThrow(() => Sandbox.Compiler(NoCompiler).CompileKernel(source, "A", []));
    }

    [Test]
    public void AnUnwritableCacheIsReportedAndDoesNotStopTheWork()
    {
        string file = Sandbox.Add("blocked", "a file where a folder should be");
        ShaderCompiler compiler = new(Path.Combine(file, "cache"), Sandbox.Includes);
        Assert.DoesNotThrow(() => compiler.CompileKernel(Parse(), "A", []));
        Assert.That(compiler.CacheProblem, Does.Contain("cannot be written"));
    }
}
