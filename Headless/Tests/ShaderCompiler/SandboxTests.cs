using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Base of tests that compile something.</summary>
public abstract class SandboxTests
{
    private protected ShaderSandbox Sandbox { get; private set; } = null!;

    [SetUp]
    public void CreateSandbox() => Sandbox = new ShaderSandbox();

    [TearDown]
    public void DeleteSandbox() => Sandbox.Dispose();

    private protected static ShaderResource Resource(ShaderBinary binary, string name) =>
        binary.Resources.Single(r => r.Name == name);

    /// <summary>Whether a number stands in the code.</summary>
    private protected static bool Holds(ShaderBinary binary, float constant) =>
        Enumerable.Range(0, binary.SpirV.Length / 4).Any(i => BitConverter.ToSingle(binary.SpirV, 4 * i) == constant);
}
