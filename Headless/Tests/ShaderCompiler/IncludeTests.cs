using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class IncludeTests : SandboxTests
{
    private const string Body = """
        RWStructuredBuffer<float> _Out;
        [numthreads(1, 1, 1)] void CS() { _Out[0] = Value(); }
        """;

    [TestCase("Beside.hlsl", "Assets/Beside.hlsl")]
    [TestCase("Sub/Deeper.hlsl", "Assets/Sub/Deeper.hlsl")]
    [TestCase("../Other/Up.hlsl", "Other/Up.hlsl")]
    [TestCase("Assets/Sub/FromRoot.hlsl", "Assets/Sub/FromRoot.hlsl")]
    [TestCase("Packages/com.example.tool/Shaders/Tool.hlsl", "Packages/folder of another name/Shaders/Tool.hlsl")]
    public void EveryPathRule(string include, string file)
    {
        Sandbox.Add("Packages/folder of another name/package.json", """{"name": "com.example.tool", "version": "1.2.0"}""");
        Sandbox.Add(file, "float Value() { return 1; }\n");
        Assert.DoesNotThrow(() => Sandbox.Kernel($"#include \"{include}\"\n{Body}"));
    }

    [Test]
    public void LocalPackageOfTheManifest()
    {
        Sandbox.Add("Packages/manifest.json", """{"dependencies": {"com.example.far": "file:../elsewhere"}}""");
        Sandbox.Add("elsewhere/package.json", """{"name": "com.example.far", "version": "2.0.0"}""");
        Sandbox.Add("elsewhere/Far.hlsl", "float Value() { return 1; }\n");
        Assert.DoesNotThrow(() => Sandbox.Kernel($"#include \"Packages/com.example.far/Far.hlsl\"\n{Body}"));
    }

    [Test]
    public void IncludesOfIncludesAreRelativeToTheirFile()
    {
        Sandbox.Add("Assets/Sub/Outer.hlsl", "#include \"Inner.hlsl\"\n");
        Sandbox.Add("Assets/Sub/Inner.hlsl", "float Value() { return 1; }\n");
        Assert.DoesNotThrow(() => Sandbox.Kernel($"#include \"Sub/Outer.hlsl\"\n{Body}"));
    }

    [Test]
    public void GuardsPragmaOnceAndCycles()
    {
        Sandbox.Add("Assets/Once.hlsl", "#pragma once\n#include \"Guarded.hlsl\"\nfloat Value() { return Half(); }\n");
        Sandbox.Add(
            "Assets/Guarded.hlsl", "#ifndef GUARDED\n#define GUARDED\n#include \"Once.hlsl\"\nfloat Half() { return 0.5; }\n#endif\n");
        Assert.DoesNotThrow(() => Sandbox.Kernel(
            $"#include \"Once.hlsl\"\n#include \"Guarded.hlsl\"\n#include \"Once.hlsl\"\n{Body}"));
    }

    [Test]
    public void MissingIncludeCountsOnlyWhereItIsReached()
    {
        Assert.DoesNotThrow(() => Sandbox.Kernel(
            $"#if defined(NEVER)\n#include \"Packages/com.none/None.hlsl\"\n#endif\nfloat Value() {{ return 1; }}\n{Body}"));
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel($"// first\n#include \"None.hlsl\"\n{Body}"));
        Assert.That(error!.Problem, Does.StartWith("Couldn't open include file 'None.hlsl'."));
        Assert.That((error.File, error.Line), Is.EqualTo(("Assets/Test.compute", 3)));
    }

    [Test]
    public void CommentedDirectivesAreLeftAlone()
    {
        Assert.DoesNotThrow(() => Sandbox.Kernel(
            $"/*\n#include \"None.hlsl\"\n#pragma kernel Nothing\n*/\n// #include \"None.hlsl\"\nfloat Value() {{ return 1; }}\n{Body}"));
    }

    [Test]
    public void PragmasOfIncludesNeedTheirOwnDirective()
    {
        Sandbox.Add("Assets/Keys.hlsl", "#pragma multi_compile _ EXTRA\n");
        string plain = Sandbox.Add("Assets/Plain.compute", "#pragma kernel CS\n#include \"Keys.hlsl\"\n");
        string with = Sandbox.Add("Assets/With.compute", "#pragma kernel CS\n#include_with_pragmas \"Keys.hlsl\"\n");
        Assert.That(ComputeSource.Parse(plain, Sandbox.Includes).KeywordSets, Is.Empty);
        Assert.That(ComputeSource.Parse(with, Sandbox.Includes).KeywordSets, Has.Count.EqualTo(1));
    }

    [TestCase("UnityCG.cginc")]
    [TestCase("HLSLSupport.cginc")]
    [TestCase("Lighting.cginc")]
    [TestCase("AutoLight.cginc")]
    public void BuiltInFiles(string name)
    {
        Assert.DoesNotThrow(() => Sandbox.Kernel($"#include \"{name}\"\nfixed Value() {{ return UNITY_REVERSED_Z; }}\n{Body}"));
    }
}
