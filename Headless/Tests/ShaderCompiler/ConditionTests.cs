using System.Globalization;
using System.Text.RegularExpressions;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Which branches of #if are kept, and which files are included for them.</summary>
public sealed class ConditionTests : SandboxTests
{
    private const string Body = "RWStructuredBuffer<float> _Out;\n[numthreads(1, 1, 1)] void CS() { _Out[0] = Value(); }\n";

    private const string Macros = """
        #define ONE 1
        #define EMPTY
        #define ALIAS ONE
        #define NONE 0
        #define IS_OFF (!defined(FEATURE))
        #define SUM(a, b) (a + b)
        #define TWICE(x) SUM(x, x)
        #define CALLER TWICE
        #define LONG ONE + \
            ONE

        """;

    [TestCase("ONE")]
    [TestCase("ALIAS == 1 && !NONE")]
    [TestCase("defined ONE && defined(EMPTY) && !defined(FEATURE)")]
    [TestCase("IS_OFF")]
    [TestCase("TWICE(3) == 6 && SUM(1, SUM(2, 3)) == 6")]
    [TestCase("TWICE (ONE) == 2 && CALLER(2) == 4")]
    [TestCase("LONG == 2 && UNHEARD == 0")]
    [TestCase("1 + 2 * 3 == 7 && (1 + 2) * 3 == 9 && 7 / 2 == 3 && -7 % 3 == -1")]
    [TestCase("1 << 4 == 16 && (6 & 3) == 2 && (6 | 3) == 7 && (6 ^ 3) == 5 && ~0 == -1")]
    [TestCase("0x10 == 16 && 010 == 8 && 2147483647 + 1 < 0")]
    [TestCase("1 || 0 && 0")]
    [TestCase("10 - 4 - 3 == 3 && 2 < 3 == 1")]
    [TestCase("UNITY_VERSION >= 202220 && UNITY_VERSION < 600000 && SHADER_API_D3D11")]
    [TestCase("ONE // && 0")]
    [TestCase("ONE /* && 0 */ && 1")]
    [TestCase("ONE && \\\n  ALIAS")]
    public void AConditionIsWorkedOutAsTheCompilerDoes(string condition)
    {
        Sandbox.Add("Assets/Taken.hlsl", "float Value() { return 1; }\n");
        Sandbox.Add("Assets/Other.hlsl", "not HLSL at all\n");
        Expands($"{Macros}#if {condition}\n#include \"Taken.hlsl\"\n#else\n#include \"Other.hlsl\"\n#endif\n", "Taken.hlsl");
        string end = condition.Contains("//", StringComparison.Ordinal) ? "\n" : "";
        Expands($"{Macros}#if !({condition.Replace("// && 0", "", StringComparison.Ordinal)})\n#include \"Other.hlsl\"\n#elif 1\n#include \"Taken.hlsl\"\n#endif\n{end}", "Taken.hlsl");
    }

    [Test]
    public void NestedBranches()
    {
        Sandbox.Add("Assets/Taken.hlsl", "float Value() { return 1; }\n");
        Expands(
            """
            #define A 2
            #if A == 1
              #if 1
                #include "None.hlsl"
              #else
                #include "None.hlsl"
              #endif
              #define TAKEN
            #elif A == 2
              # ifdef TAKEN
                #include "None.hlsl"
              # elif A == 2
                #undef A
                #ifndef A
                  #include "Taken.hlsl"
                #endif
              # elif 1
                #include "None.hlsl"
              # else
                #include "None.hlsl"
              # endif
            #elif 1
              #include "None.hlsl"
            #else
              #include "None.hlsl"
            #endif

            """,
            "Taken.hlsl");
    }

    [Test]
    public void AnIncludeOfABranchThatIsNotTakenIsNotLookedFor()
    {
        Sandbox.Add("Assets/Deep.hlsl", "#include \"Deeper.hlsl\"\n");
        Expands("#if defined(SHADER_API_METAL)\n#include \"None.hlsl\"\n#include \"Deep.hlsl\"\n#include NOT_EVEN_A_NAME\n#error Metal\n#endif\nfloat Value() { return 1; }\n");
    }

    [Test]
    public void GuardedFilesAreReadOnce()
    {
        Sandbox.Add("Assets/A.hlsl", "#ifndef A_INCLUDED\n#define A_INCLUDED\n#include \"B.hlsl\"\nfloat Value() { return B(); }\n#endif\n");
        Sandbox.Add("Assets/B.hlsl", "#if !defined(B_INCLUDED)\n#define B_INCLUDED\n#include \"C.hlsl\"\nfloat B() { return C(); }\n#endif\n");
        Sandbox.Add("Assets/C.hlsl", "#pragma once\n#include \"A.hlsl\"\nfloat C() { return 3.25; }\n");
        string text = Expands(string.Concat(Enumerable.Repeat("#include \"A.hlsl\"\n#include \"B.hlsl\"\n#include \"C.hlsl\"\n", 3)), "A.hlsl", "B.hlsl", "C.hlsl");
        Assert.That(Regex.Count(text, "3.25"), Is.EqualTo(1));
    }

    // 30 files that each include all that follow them: without guards 2^30 includes.
    [Test]
    public void GuardsHoldBackManyIncludes()
    {
        string[] names = [.. Enumerable.Range(0, 30).Select(i => $"F{i}.hlsl")];
        for (int i = 0; i < names.Length; i++)
        {
            string includes = string.Concat(names.Skip(i + 1).Select(n => $"#include \"{n}\"\n"));
            Sandbox.Add("Assets/" + names[i], $"#ifndef F{i}\n#define F{i} 1\n{includes}static const float c{i} = {i};\n#endif\n");
        }
        Expands("#include \"F0.hlsl\"\nfloat Value() { return c0 + c29; }\n", names);
        Assert.DoesNotThrow(() => Sandbox.Kernel($"#pragma multi_compile _ KEY\n#ifdef KEY\n#include \"F1.hlsl\"\n#endif\n#include \"F0.hlsl\"\nfloat Value() {{ return c0; }}\n{Body}", "KEY"));
    }

    [Test]
    public void BranchesOfKeywordsAreKept()
    {
        Sandbox.Add("Assets/On.hlsl", "float Value() { return 1.25; }\n");
        Sandbox.Add("Assets/Off.hlsl", "float Value() { return 2.25; }\n");
        const string source = """
            #ifdef KEY
            #define FILE 1
            #define SAME 7
            #else
            #define FILE 2
            #define SAME 7
            #endif
            #if FILE == 1 && SAME == 7
            #include "On.hlsl"
            #elif SAME == 7
            #include "Off.hlsl"
            #else
            #include "None.hlsl"
            #endif
            #pragma multi_compile _ KEY

            """;
        Expands(source, "On.hlsl", "Off.hlsl");
        Assert.That(Holds(Sandbox.Kernel(source + Body, "KEY"), 1.25f) && Holds(Sandbox.Kernel(source + Body), 2.25f));
    }

    [Test]
    public void KeywordsOfAKernelAndOfPragmasInIncludesAreKeptToo()
    {
        Sandbox.Add("Assets/Keys.hlsl", "#pragma once\n#ifndef SHADER_API_METAL\n#pragma multi_compile _ EXTRA\n#else\n#pragma multi_compile METAL\n#endif\n");
        const string source = """
            #pragma kernel Wide WIDE=4
            #if defined(EXTRA) && WIDE == 4
            float Value() { return 1.25; }
            #elif defined(METAL)
            #include "None.hlsl"
            #else
            float Value() { return 2.25; }
            #endif
            #include_with_pragmas "Keys.hlsl"
            RWStructuredBuffer<float> _Out;
            [numthreads(1, 1, 1)] void CS() { _Out[0] = Value(); }
            [numthreads(1, 1, 1)] void Wide() { _Out[0] = Value(); }

            """;
        ComputeSource parsed = Parse(source);
        Assert.That(parsed.KeywordSets.Select(s => string.Join('|', s.Keywords)), Is.EqualTo(new[] { "|EXTRA" }));
        Assert.That(Holds(Sandbox.Compiler().CompileKernel(parsed, "Wide", ["EXTRA"]), 1.25f));
        Assert.That(Holds(Sandbox.Compiler().CompileKernel(parsed, "Wide", []), 2.25f));
        Assert.That(Holds(Sandbox.Compiler().CompileKernel(parsed, "CS", ["EXTRA"]), 2.25f));
    }

    [Test]
    public void StagesAndTargetsAreLeftToTheCompiler()
    {
        IReadOnlyList<ShaderBinary> stages = Sandbox.Pass("""
            #pragma vertex vert
            #pragma fragment frag
            #pragma target 3.5
            #pragma target 4.5 KEY
            #pragma multi_compile _ KEY
            #if defined(SHADER_STAGE_VERTEX)
            float4 vert(float4 p : POSITION) : SV_Position { return p; }
            #elif SHADER_TARGET >= 45
            float4 frag() : SV_Target { return 4.5; }
            #else
            float4 frag() : SV_Target { return 3.5; }
            #endif
            """, "KEY");
        Assert.That(Holds(stages[1], 4.5f));
    }

    [Test]
    public void AFileIsIncludedByAMacro()
    {
        Sandbox.Add("Assets/Named.hlsl", "float Value() { return 1; }\n");
        Expands("#define HEADER \"Named.hlsl\"\n#include HEADER\n", "Named.hlsl");
    }

    [Test]
    public void LinesOfErrorsAreRightAfterAllOfIt()
    {
        Sandbox.Add("Assets/Guarded.hlsl", "#pragma once\n#ifndef G\n#define G\n#if 0\n\n#include \"None.hlsl\"\n#endif\nfloat Good() { return 1; }\n#endif\n");
        Sandbox.Add("Assets/Bad.hlsl", "#if 0\n/* #endif\n*/\n#elif 1 \\\n  && 1\n\nfloat Bad() { return missing; }\n#endif\n");
        const string start = "#include \"Guarded.hlsl\"\n#include \"Guarded.hlsl\"\n#ifdef NEVER\nx\n\ny\n#else\n#define M(x) \\\n  x\n#endif\n";
        var main = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel($"{start}float Value() {{ return absent; }}\n{Body}"));
        Assert.That((main!.File, main.Line), Is.EqualTo(("Assets/Test.compute", 12)));
        var included = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel($"{start}#include \"Bad.hlsl\"\n{Body}"));
        Assert.That((included!.File, included.Line), Is.EqualTo(("Assets/Bad.hlsl", 7)));
    }

    /// <summary>Random nests of conditions: behind glslang's preprocessor is the same text, whether or not branches were taken out before.</summary>
    [Test]
    public void WhatIsTakenOutTheCompilerWouldNotRead([Range(1, 12)] int seed)
    {
        Random random = new(seed);
        string text = "#pragma kernel CS\n#pragma multi_compile _ KEY OTHER\n" + string.Concat(Enumerable.Range(0, 12).Select(_ => Group(random, 0)));
        ExpandedSource expanded = Parse(text).Expanded;
        Assert.That(expanded.Text.Count(c => c == ';'), Is.LessThan(text.Count(c => c == ';')));
        foreach (string[] keywords in new string[][] { [], ["KEY"], ["OTHER"] })
        {
            string defines = string.Concat(keywords.Select(k => $"#define {k} 1\n"));
            Assert.That(Preprocessed(defines + expanded.Text), Is.EqualTo(Preprocessed(defines + Regex.Replace(text, "#pragma.*", ""))), text);
        }
    }

    private static string Group(Random random, int depth)
    {
        string text = $"{Test(random)}\n{Content(random, depth)}";
        for (int i = random.Next(3); i > 0; i--) text += $"#elif {Expression(random)}\n{Content(random, depth)}";
        if (random.Next(2) == 0) text += $"#else\n{Content(random, depth)}";
        return text + "#endif\n";
    }

    private static string Content(Random random, int depth)
    {
        string text = "";
        for (int i = random.Next(1, 4); i > 0; i--)
        {
            text += random.Next(5) switch
            {
                0 => string.Format(CultureInfo.InvariantCulture, "#undef {0}\n#define {0} {1}\n", Name(random), random.Next(3)),
                1 => $"#undef {Name(random)}\n",
                2 when depth < 3 => Group(random, depth + 1),
                _ => $"float x{random.Next(1000)};\n",
            };
        }
        return text;
    }

    private static string Test(Random random) => random.Next(3) switch
    {
        0 => $"#ifdef {Name(random)}",
        1 => $"#ifndef {Name(random)}",
        _ => $"#if {Expression(random)}",
    };

    private static string Expression(Random random) => random.Next(6) switch
    {
        0 => $"defined({Name(random)})",
        1 => $"!defined {Name(random)}",
        2 => $"{Name(random)} == {random.Next(3)}",
        3 => $"({Expression(random)} && {Expression(random)})",
        4 => $"({Expression(random)} || {Expression(random)})",
        _ => $"{Name(random)} + {random.Next(2)}",
    };

    private static string Name(Random random) => "A B C D KEY".Split(' ')[random.Next(5)];

    private static string Preprocessed(string text)
    {
        StageJob job = new(new ExpandedSource("", ["Test"], [], []), ShaderStage.Compute, "CS", text, "a test");
        string preprocessed = new GlslangProcess("glslangValidator").Preprocess(job);
        return string.Join(' ', preprocessed.Split('\n').Where(l => !l.StartsWith("#line", StringComparison.Ordinal)).Select(l => l.Trim()).Where(l => l.Length > 0));
    }

    private ComputeSource Parse(string source) =>
        ComputeSource.Parse(Sandbox.Add("Assets/Test.compute", "#pragma kernel CS\n" + source), Sandbox.Includes);

    /// <summary>Compiles, with these files and no others.</summary>
    private string Expands(string source, params string[] files)
    {
        ExpandedSource expanded = Parse(source + Body).Expanded;
        Assert.That(expanded.Files.Skip(1), Is.EquivalentTo(files.Select(f => "Assets/" + f)), source);
        Assert.That(expanded.Messages, Is.Empty);
        Sandbox.Kernel(source + Body);
        return expanded.Text;
    }
}
