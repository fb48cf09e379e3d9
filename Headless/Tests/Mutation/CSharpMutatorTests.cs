using Headless.Mutation.CSharp;
using NUnit.Framework;

namespace Headless.Tests.Mutation;

public class CSharpMutatorTests
{
    private static string[] Changes(string member) => [.. CSharpMutator.Find("Runtime/A.cs", $"class A {{ {member} }}").Select(m => $"{m.Operator} '{m.Original}' -> '{m.Replacement}'")];

    [TestCase("float F(float a) => a + 2f;", "arithmetic '+' -> '-'", "term '+ 2f' -> ''", "constant '2f' -> '2.2f'")]
    [TestCase("float F(float a) => Mathf.Max(a, b);", "min/max 'Max' -> 'Min'")]
    [TestCase("float F(float a) => Mathf.Abs(a);", "drop function 'Mathf.Abs(a)' -> '(a)'")]
    [TestCase("bool F() => a && !b;", "logical '&&' -> '||'", "condition '!' -> ''")]
    [TestCase("void F() { a = b; }", "statement 'a = b;' -> ';'")]
    [TestCase("void F() { if (a) { } }", "condition 'a' -> '!(a)'")]
    [TestCase("private const int N = 3;", "constant '3' -> '4'")]
    public void EachOperatorIsFound(string member, params string[] expected) => Assert.That(Changes(member), Is.EquivalentTo(expected));

    [TestCase("internal const int N = 3;")]
    [TestCase("[Range(0, 1)] float a;")]
    [TestCase("void F() { throw new E(\"a\" + 1); }")]
    [TestCase("string F() => $\"{a + 1}\";")]
    public void WhatOthersCompileInAndMessagesAreLeftAlone(string member) => Assert.That(Changes(member), Is.Empty);
}
