using System.Reflection;
using NUnit.Framework.Internal;

namespace Headless.Engine;

/// <summary>Arguments and expected result of a test, which NUnit 3.6 keeps internal.</summary>
static class TestCaseValues
{
    const BindingFlags Flags = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic;

    static readonly PropertyInfo s_Arguments = Require("Arguments");
    static readonly PropertyInfo s_HasExpected = Require("HasExpectedResult");
    static readonly PropertyInfo s_Expected = Require("ExpectedResult");

    public static object?[]? Arguments(TestMethod test) => (object?[]?)s_Arguments.GetValue(test);

    public static bool TryGetExpected(TestMethod test, out object? expected)
    {
        bool has = (bool)s_HasExpected.GetValue(test)!;
        expected = has ? s_Expected.GetValue(test) : null;
        return has;
    }

    static PropertyInfo Require(string name) => typeof(TestMethod).GetProperty(name, Flags | BindingFlags.DeclaredOnly)
        ?? throw new MissingMemberException($"This NUnit has no TestMethod.{name}.");
}
