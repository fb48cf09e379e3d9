using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>What FXC takes and glslang does not, where macros write it.</summary>
public sealed class FxcRulesTests : SandboxTests
{
    private const string Body = "RWStructuredBuffer<float> _Out;\n[numthreads(1, 1, 1)] void CS() { _Out[0] = Value(); }\n";

    [TestCase("half")]
    [TestCase("min16float")]
    [TestCase("min10float")]
    public void TheFullVersionOfAFunctionIsKept(string type)
    {
        string reduced = $"{type} Scaled({type} x, in {type}3 y[2])\n{{\n return x * 2.25 + y[0].x;\n}}\n";
        const string full = "float Scaled(float x, in float3 y[2]) { return x * 3.25 + y[0].x; }\n";
        const string value = "StructuredBuffer<float> _In;\nfloat Value() { float3 y[2]; y[0] = _In[1]; y[1] = 0; return Scaled(_In[0], y); }\n";
        foreach (string source in new[] { reduced + full, full + reduced })
        {
            ShaderBinary binary = Sandbox.Kernel(source + value + Body);
            Assert.That((Holds(binary, 2.25f), Holds(binary, 3.25f)), Is.EqualTo((false, true)));
        }
    }

    [Test]
    public void AVersionIsCalledBeforeTheOneThatIsKept()
    {
        ShaderBinary binary = Sandbox.Kernel(
            "StructuredBuffer<float> _In;\nhalf Scaled(half x)\n{\n return x * 2.25;\n}\nfloat Value() { return Scaled(_In[0]); }\n"
            + "float Scaled(float x) { return x * 3.25; }\n" + Body);
        Assert.That((Holds(binary, 2.25f), Holds(binary, 3.25f)), Is.EqualTo((false, true)));
    }

    [Test]
    public void VersionsOfOtherTypesAndSizesStay()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            #define VERSIONS(NAME, X, CODE) half NAME(half X) { CODE; } half2 NAME(half2 X) { CODE; } float NAME(float X) { CODE; } float2 NAME(float2 X) { CODE; }
            VERSIONS(Twice, x, return x * 2.25)
            VERSIONS(Thrice, x, return x * 3.25)
            uint Twice(uint x) { return x * 7; }
            min16uint Twice(min16uint x) { return x * 9; }
            float Value() { return Twice(Thrice(float2(_In[0], 1))).y + Twice(_In[1]) + Twice((uint)_In[2]); }

            """.Insert(0, "StructuredBuffer<float> _In;\n") + Body);
        Assert.That(Holds(binary, 2.25f) && Holds(binary, 3.25f));
    }

    [Test]
    public void AFunctionThatIsThereTwiceStaysAnError()
    {
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel(
            $"half Value(half x) {{ return x; }}\nfloat Value() {{ return 1; }}\n\nfloat Value()\n{{ return 2; }}\n{Body}"));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/Test.compute", 6)));
        Assert.That(error.Problem, Does.Contain("already has a body"));
    }

    [Test]
    public void LinesOfErrorsStayWhereAVersionIsDropped()
    {
        Sandbox.Add("Assets/Versions.hlsl", "#define BOTH(T) T F(T x) \\\n { return x; }\nBOTH(float)\nBOTH(half)\n\nfloat Bad() { return missing; }\n");
        var error = Assert.Throws<ShaderCompileException>(() => Sandbox.Kernel($"#include \"Versions.hlsl\"\nfloat Value() {{ return F(1); }}\n{Body}"));
        Assert.That((error!.File, error.Line), Is.EqualTo(("Assets/Versions.hlsl", 6)));
        Assert.That(error.Problem, Does.Contain("'missing'"));
    }

    [Test]
    public void SemicolonsOfNothing()
    {
        ShaderBinary binary = Sandbox.Kernel("""
            #define NOTHING
            cbuffer Params { float4 _A;; NOTHING; float _B; NOTHING; };
            struct S { NOTHING; float a;; float b; NOTHING;; };
            float Value() { S s; s.a = _A.w;; s.b = _B; for (;;) { break; } return s.a + s.b; }

            """ + Body);
        Assert.That(Resource(binary, "Params").Members.Select(m => (m.Name, m.Offset)), Is.EqualTo(new[] { ("_A", 0), ("_B", 16) }));
    }

    [Test]
    public void LoopsThatAMacroBeginsInOneBranch()
    {
        const string source = """
            #pragma multi_compile _ MANY
            StructuredBuffer<float> _In;
            #define BEGIN(count) for (uint i = 0; i < count; i++) {
            #define END }
            float Value()
            {
                float sum = 0;
            #if MANY
                for (uint i = 0; i < 8; i++) { sum += _In[i] * 1.25; }
            #endif
                BEGIN(4)
                sum += _In[i] * 2.25;
                END
                return sum;
            }

            """;
        Assert.That(Holds(Sandbox.Kernel(source + Body), 1.25f), Is.False);
        Assert.That(Holds(Sandbox.Kernel(source + Body, "MANY"), 1.25f));
    }

    [Test]
    public void KeywordsOfADynamicBranchAreTrueOrFalse()
    {
        const string source = """
            #pragma dynamic_branch _ LINEAR SQUARE
            #pragma dynamic_branch_local ROOT
            float Value() { return LINEAR ? 1.25 : SQUARE || ROOT ? 2.25 : 3.25; }

            """;
        Assert.That(Chosen(), Is.EqualTo((false, false, true)));
        Assert.That(Chosen("LINEAR"), Is.EqualTo((true, false, false)));
        Assert.That(Chosen("ROOT"), Is.EqualTo((false, true, false)));

        (bool, bool, bool) Chosen(params string[] keywords)
        {
            ShaderBinary binary = Sandbox.Kernel(source + Body, keywords);
            return (Holds(binary, 1.25f), Holds(binary, 2.25f), Holds(binary, 3.25f));
        }
    }
}
