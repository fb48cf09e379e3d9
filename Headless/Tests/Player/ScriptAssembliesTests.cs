using Headless.Player;
using Headless.Player.Scripts;
using NUnit.Framework;

namespace Headless.Tests.Player;

public sealed class ScriptAssembliesTests
{
    private static ScriptAssemblies Own => new(AppContext.BaseDirectory);

    [Test]
    public void WhatThePlayerHasIsNotLoadedTwice() =>
        Assert.That(Own.Find("UnityEngine"), Is.SameAs(typeof(UnityEngine.GameObject).Assembly));

    [Test]
    public void AnUnknownAssemblyIsNull() => Assert.That(Own.Find("Nowhere.To.Be.Found"), Is.Null);

    [Test]
    public void AFolderThatIsMissingHasNoAssemblies() => Assert.That(new ScriptAssemblies("/nowhere").LoadAll(), Is.Empty);

    [TestCase("Method", "--executeMethod must be Namespace.Class.Method, found 'Method'.")]
    [TestCase("Headless.Nowhere.Run", "--executeMethod: no class 'Headless.Nowhere' in the script assemblies of ")]
    public void WrongMethodsAreNamed(string name, string message) =>
        Assert.That(() => new ScriptAssemblies("/nowhere").FindMethod("--executeMethod", name), Throws.TypeOf<UsageException>().With.Message.StartsWith(message));
}
