using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

public sealed class ShaderLabErrorTests : SandboxTests
{
    [TestCase("Shader \"S\" {\n Nonsense }", 2, "unexpected 'Nonsense'")]
    [TestCase("Shader \"S\" {\n SubShader {\n Blend Sideways One } }", 3, "unknown value 'Sideways'")]
    [TestCase("Shader \"S\" { SubShader {\n\n UsePass \"A/B\" } }", 3, "UsePass is not supported")]
    [TestCase("Shader \"S\" { SubShader {\n GrabPass { } } }", 2, "GrabPass")]
    [TestCase("Shader \"S\" { SubShader { Pass\n { Cull Off } } }", 2, "fixed function")]
    [TestCase("Shader \"S\" { Properties {\n _A (\"a\", Triangle) = 1 } }", 2, "unknown property type 'Triangle'")]
    [TestCase("Shader \"S\" { Properties {\n _A (\"a\", Float) = white } }", 2, "expected a number")]
    [TestCase("Shader \"S\" { Properties { _A (\"a\", Float) = 1\n _A (\"a\", Float) = 1 } }", 2, "declared twice")]
    [TestCase("Shader \"S\" {\n SubShader { Pass { HLSLPROGRAM\n", 2, "HLSLPROGRAM without ENDHLSL")]
    [TestCase("Shader \"S\" {\n SubShader {\n", 3, "end of file")]
    [TestCase("Shader \"S {\n }", 1, "without closing quote")]
    [TestCase("Shader \"S\" { }\n}", 2, "expected the end of the file")]
    [TestCase("Shader \"S\" { SubShader { ColorMask RGX } }", 1, "unknown ColorMask 'RGX'")]
    public void BadSyntaxNamesFileAndLine(string text, int line, string expected)
    {
        string path = Sandbox.Add("Assets/S.shader", text);
        var error = Assert.Throws<ShaderCompileException>(() => ShaderLabSource.Parse(path, Sandbox.Includes));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/S.shader", line)));
        Assert.That(error.Message, Does.Contain(expected).And.Contain($"Assets/S.shader({line})"));
    }

    [Test]
    public void ASurfaceShaderFailsOnUse()
    {
        string path = Sandbox.Add("Assets/S.shader", "Shader \"S\" { SubShader {\nCGPROGRAM\n#pragma surface surf Standard\nENDCG\n} }");
        ShaderPass pass = ShaderLabSource.Parse(path, Sandbox.Includes).SubShaders[0].Passes[0];
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Compiler().CompilePass(pass, []));
        Assert.That(error!.Message, Does.Contain("surface shaders are not supported").And.Contain("S.shader(3)"));
    }

    [TestCase("Stencil { Ref 2 Comp Always Pass Replace }", "", "Stencil is not supported")]
    [TestCase("", "#pragma surface surf Standard", "surface shaders are not supported")]
    [TestCase("", "#pragma hull H", "tessellation is not supported")]
    [TestCase("", "", "no \"#pragma vertex function\"")]
    public void WhatUnityKnowsAndThePlayerDoesNotFailsOnUse(string state, string pragma, string expected)
    {
        string path = Sandbox.Add(
            "Assets/S.shader", $"Shader \"S\" {{ SubShader {{ Pass {{ {state}\nCGPROGRAM\n{pragma}\nENDCG }} }} }}");
        ShaderPass pass = ShaderLabSource.Parse(path, Sandbox.Includes).SubShaders[0].Passes[0];
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Compiler().CompilePass(pass, []));
        Assert.That(error!.Message, Does.Contain(expected));
    }
}
