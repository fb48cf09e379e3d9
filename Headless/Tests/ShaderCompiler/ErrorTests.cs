using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class ErrorTests : SandboxTests
{
    [Test]
    public void LineOfTheMainFile()
    {
        Sandbox.Add("Assets/Long.hlsl", new string('\n', 40) + "float Value() { return 1; }\n");
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel("""
            #include "Long.hlsl"
            RWStructuredBuffer<float> _Out;
            [numthreads(1, 1, 1)] void CS()
            {
                _Out[0] = Value() + missing;
            }
            """));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/Test.compute", 6)));
        Assert.That(error.Message, Does.StartWith("Shader error in 'Test.compute': 'missing'"));
        Assert.That(error.Message, Does.Contain("kernel 'CS'").And.EndWith("at Assets/Test.compute(6) (on d3d11)"));
    }

    [Test]
    public void LineOfAnInclude()
    {
        Sandbox.Add("Assets/Bad.hlsl", "float Good() { return 1; }\n\nfloat Bad() { return missing; }\n");
        var error = Assert.Throws<ShaderCompileException>(
            () => Sandbox.Kernel("#include \"Bad.hlsl\"\n[numthreads(1, 1, 1)] void CS() { Bad(); }"));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/Bad.hlsl", 3)));
    }

    [Test]
    public void LineOfAProgramInAShader()
    {
        string path = Sandbox.Add("Assets/S.shader", """
            Shader "S"
            {
                HLSLINCLUDE
                float4 Colour() { return wrong; }
                ENDHLSL
                SubShader
                {
                    Pass
                    {
                        HLSLPROGRAM
                        #pragma vertex vert
                        #pragma fragment frag
                        float4 vert() : SV_Position { return 0; }
                        float4 frag() : SV_Target { return Colour(); }
                        ENDHLSL
                    }
                }
            }
            """);
        ShaderPass pass = ShaderLabSource.Parse(path, Sandbox.Includes).SubShaders[0].Passes[0];
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Compiler().CompilePass(pass, []));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/S.shader", 4)));
    }

    [Test]
    public void ErrorDirectivesKeepTheirText()
    {
        var error = Assert.Throws<ShaderCompileException>(
            () => Sandbox.Kernel("#error Don't use \"this\" (yet)\n[numthreads(1, 1, 1)] void CS() { }"));
        Assert.That(error!.Problem, Does.StartWith("Don't use \"this\" (yet)"));
        Assert.That(error.Line, Is.EqualTo(2));
    }

    [Test]
    public void MissingFunction()
    {
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel("[numthreads(1, 1, 1)] void Other() { }"));
        Assert.That(error!.Message, Does.Contain("no function 'CS'"));
    }

    [Test]
    public void MissingKernelPragma()
    {
        string path = Sandbox.Add("Assets/None.compute", "[numthreads(1, 1, 1)] void CS() { }");
        var error = Assert.Throws<ShaderCompileException>(() => ComputeSource.Parse(path, Sandbox.Includes));
        Assert.That(error!.Message, Does.Contain("#pragma kernel"));
    }

    [Test]
    public void ACrashOfTheCompilerIsReportedAndSurvived()
    {
        var error = Assert.Throws<ShaderCompileException>(
            () => Sandbox.Kernel("const static uint N = 4;\n[numthreads(N * 2, 1, 1)] void CS() { }"));
        Assert.That(error!.Message, Does.Contain("glslangValidator stopped").And.Contain("kernel 'CS'"));
        Assert.DoesNotThrow(() => Sandbox.Kernel("[numthreads(1, 1, 1)] void CS() { }"));
    }
}
