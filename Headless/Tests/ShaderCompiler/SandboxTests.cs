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
}
