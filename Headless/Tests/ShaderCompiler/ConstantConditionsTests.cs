using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>What hangs on constants is hidden from the driver; a loop of fixed length is not.</summary>
public sealed class ConstantConditionsTests
{
    private const string Constants = "cbuffer Set { float _Level; int _Count; float4 _More; }; RWStructuredBuffer<float> _Result; StructuredBuffer<int> _Data;\n";

    private ShaderSandbox sandbox = null!;

    [SetUp]
    public void SetUp() => sandbox = new ShaderSandbox();

    [TearDown]
    public void TearDown() => sandbox.Dispose();

    [TestCase("if (_Level > 1) _Result[0] = 2;")]
    [TestCase("for (int i = 0; i < _Count; i++) _Result[i] = 2;")]
    [TestCase("int i = 0; while (i * _More.w < 4) _Result[i++] = 2;")]
    [TestCase("switch (_Count) { case 0: _Result[0] = 2; break; case 1: _Result[1] = 3; break; default: _Result[2] = 4; break; }")]
    [TestCase("float level = _Level; level *= 2; if (level > 1) _Result[0] = 2;")]
    [TestCase("if (Twice(_Level) > 1) _Result[0] = 2;")]
    [TestCase("float twice; Double(_More.x, twice); if (twice > 1) _Result[0] = 2;")]
    [TestCase("float list[4]; for (int i = 0; i < 4; i++) list[_Data[i]] = _Level; _Result[0] = list[_Data[4]];")]
    public void APlaceThatHangsOnConstantsIsHidden(string body) => Assert.That(Hidden(body), Is.Not.Zero);

    [TestCase("for (int i = 0; i < 8; i++) _Result[i] = _Level;")]
    [TestCase("for (int i = 0; i < _Data[0]; i++) _Result[i] = _Level * i;")]
    [TestCase("if (_Data[1] > 3) _Result[0] = _Level;")]
    [TestCase("_Result[0] = _Level > 1 ? _More.x : _More.y;")]
    public void OneThatDoesNotIsLeftAsItIs(string body) => Assert.That(Hidden(body), Is.Zero);

    [Test]
    public void EveryStageStaysValid()
    {
        foreach (ShaderBinary stage in sandbox.Pass("""
            #pragma vertex Vertex
            #pragma geometry Geometry
            #pragma fragment Fragment
            float _Level; int _Count;
            struct Point { float4 position : SV_Position; float level : TEXCOORD0; };
            Point Vertex(uint id : SV_VertexID)
            {
                Point p;
                p.level = 3 * _Level;
                p.position = id;
                for (int i = 0; i < _Count; i++) p.position += float4(p.level, i, 0, 1);
                return p;
            }
            [maxvertexcount(3)] void Geometry(point Point corner[1], inout TriangleStream<Point> stream)
            {
                for (int i = 0; i < _Count; i++) stream.Append(corner[0]);
            }
            float4 Fragment(Point p) : SV_Target
            {
                if (_Level > 2) discard;
                return p.level;
            }
            """))
        {
            ShaderBinary hidden = ConstantConditions.Apply(stage);
            Assert.That(hidden.SpirV.Length, Is.GreaterThan(stage.SpirV.Length), $"{stage.Stage}");
            ShaderSandbox.Validate(hidden);
        }
    }

    // Bytes that the pass adds; the result is valid.
    private int Hidden(string body)
    {
        ShaderBinary kernel = sandbox.Kernel(
            Constants + "float Twice(float x) { if (x < 0) return 0; return 2 * x; } void Double(float x, out float twice) { twice = 2 * x; }\n"
            + $"[numthreads(1, 1, 1)] void CS() {{ {body} }}");
        ShaderBinary hidden = ConstantConditions.Apply(kernel);
        ShaderSandbox.Validate(hidden);
        return hidden.SpirV.Length - kernel.SpirV.Length;
    }
}
