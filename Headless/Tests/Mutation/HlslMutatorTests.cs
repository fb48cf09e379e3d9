using Headless.Mutation;
using Headless.Mutation.Hlsl;
using NUnit.Framework;

namespace Headless.Tests.Mutation;

public class HlslMutatorTests
{
    private const string Frame = "#define N 64 + 1\nstruct S { float3 A; };\nfloat _Scale;\n[numthreads(64, 1, 1)]\nvoid K(uint3 id : SV_DispatchThreadID)\n{\n";

    private static string[] Changes(string body) => [.. HlslMutator.Find("K.compute", Frame + body + "\n}\n").Select(m => $"{m.Operator} {m.Change}")];

    [TestCase("float s = a + b * c;", "arithmetic 13: '+' -> '-'", "term 13: '+ b * c' -> ''", "arithmetic 17: '*' -> '/'")]
    [TestCase("float s = -a;", "sign 11: '-' -> ''")]
    [TestCase("bool s = a < b;", "relational 12: '<' -> '<='")]
    [TestCase("bool s = a >= b && c;", "relational 12: '>=' -> '>'", "logical 17: '&&' -> '||'")]
    [TestCase("float s = min(a, b);", "min/max 11: 'min' -> 'max'")]
    [TestCase("float s = saturate(a);", "drop function 11: 'saturate' -> ''")]
    [TestCase("float s = clamp(a, b, c);", "drop function 11: 'clamp(a, b, c)' -> '(a)'")]
    [TestCase("float s = v.yz;", "swizzle 13: 'yz' -> 'zy'")]
    [TestCase("float s = v.x;", "swizzle 13: 'x' -> 'y'")]
    [TestCase("float s = 2.0;", "constant 11: '2.0' -> '2.2'")]
    [TestCase("float s = 1e-9;", "constant 11: '1e-9' -> '0.0'")]
    [TestCase("uint s = 0u;", "constant 10: '0u' -> '1u'")]
    [TestCase("uint s = 0xffu;", "constant 10: '0xffu' -> '0xfeu'")]
    [TestCase("if (a) { }", "condition 4: '(a)' -> '(!(a))'")]
    public void EachOperatorIsFound(string body, params string[] expected) => Assert.That(Changes(body), Is.EquivalentTo(expected));

    [Test]
    public void AssignmentsAndCallsAreDeletedButNotDeclarations() => Assert.That(
        Changes("float s = a; s = b; _Out[s].A = b; Count(s);").Where(c => c.StartsWith("statement", StringComparison.Ordinal)),
        Is.EqualTo(new[] { "statement 14: 's = b;' -> ';'", "statement 21: '_Out[s].A = b;' -> ';'", "statement 36: 'Count(s);' -> ';'" }));

    [Test]
    public void WhatIsNoCodeIsLeftAlone()
    {
        const string text = Frame + "/* a + b */ // a + b\n#if A + 1 > 2 \\\n    + 3\n#endif\n[unroll] [loop]\n}\nstruct T { float a[4]; };\ncbuffer C { float b[4]; };\nBuffer<float4> d;\n";
        Assert.That(HlslMutator.Find("K.compute", text), Is.Empty);
    }

    [Test]
    public void TablesAreCode() => Assert.That(
        HlslMutator.Find("T.hlsl", "static const uint T[2] = { 3, 4 };\n").Select(m => m.Change), Is.EqualTo(new[] { "28: '3' -> '4'", "31: '4' -> '5'" }));

    [Test]
    public void LoopsStillEnd() => Assert.That(
        Changes("for (int i = 0; i < n; i++) { }"), Is.EquivalentTo(new[] { "constant 14: '0' -> '1'", "relational 19: '<' -> '<='" }));

    [Test]
    public void AChangeIsAppliedToItsPlaceAlone()
    {
        const string text = Frame + "    float s = a + b;\n}\n";
        Mutant mutant = HlslMutator.Find("K.compute", text).Single(m => m.Operator == "arithmetic");
        Assert.That(mutant.Apply(text), Is.EqualTo(text.Replace("a + b", "a - b")));
        Assert.That((mutant.Line, mutant.Source), Is.EqualTo((7, "float s = a + b;")));
    }

    [Test]
    public void AMovedLineKeepsItsKey()
    {
        Mutant before = HlslMutator.Find("K.compute", Frame + "    s = a;\n}\n").Single(), after = HlslMutator.Find("K.compute", "\n" + Frame + "\n        s = a;\n}\n").Single();
        Assert.That(after.Key, Is.EqualTo(before.Key));
        Assert.That(after.Line, Is.EqualTo(before.Line + 2));
    }
}
