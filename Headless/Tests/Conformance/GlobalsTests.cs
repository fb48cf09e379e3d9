using NUnit.Framework;

namespace Headless.Tests.Conformance;

/// <summary>Globals of a compute shader. What FXC makes of each was read from its listings (d3dcompiler_47, cs_5_0).</summary>
public sealed class GlobalsTests : HlslFixture
{
    [Test]
    public void AConstGlobalIsAUniform() =>
        Gives([2.5f, 7], "const float x; const int3 y, z;", "_Result[0] = x; _Result[1] = y.z + z.x;", shader =>
        {
            shader.SetFloat("x", 2.5f);
            shader.SetInts("y", 1, 2, 3);
            shader.SetInts("z", 4, 5, 6);
        });

    [Test]
    public void TheInitializerOfAGlobalIsNotApplied() =>
        Gives(
            [0, 0, 0, 0], "const float x = 3; float y = 4; const float a[2] = { 5, 6 }, b = (1 == 1) ? 7 : 8;",
            "_Result[0] = x; _Result[1] = y; _Result[2] = a[1]; _Result[3] = b;");

    [Test]
    public void AGlobalWithAnInitializerReadsWhatWasSet() =>
        Gives([9, 8], "const float x = 3; float y = 4;", "_Result[0] = x; _Result[1] = y;", shader =>
        {
            shader.SetFloat("x", 9);
            shader.SetFloat("y", 8);
        });

    [Test]
    public void AStaticConstGlobalIsALiteral() =>
        Gives(
            [5, 6, 4], "#define TABLE static const float\nstatic const uint N = 4; TABLE t[2] = { 5, 6 }; groupshared uint g[N];",
            "_Result[0] = t[0]; _Result[1] = t[1]; g[0] = N; _Result[2] = g[0];", shader =>
            {
                // No uniform has these names.
                shader.SetFloat("t", 99);
                shader.SetInt("N", 99);
            });

    [Test]
    public void AStaticGlobalIsAVariableOfTheThread() =>
        Gives([1, 2], "static float s = 1; void Next() { s += 1; }", "_Result[0] = s; Next(); _Result[1] = s;");

    [Test]
    public void AConstLocalKeepsItsInitializer() =>
        Gives([3, 5], "float Sum(const float a, const float b) { const float c = a + b; return c; }", "const float x = 3; _Result[0] = x; _Result[1] = Sum(2, x);");

    [Test]
    public void AConstGlobalInOneBranchOfAConditionIsAUniform() =>
        Gives([6], "#if 0\nfloat F() {\n#else\nfloat G() {\n#endif\nreturn 2; }\nconst float x;", "_Result[0] = x * G();", shader => shader.SetFloat("x", 3));

    [Test]
    public void AConstGlobalAfterAMacrosCallIsAUniform() =>
        Gives([3], "#define BLOCK(name)\nBLOCK(a)\nconst float x;", "_Result[0] = x;", shader => shader.SetFloat("x", 3));

    [Test]
    public void ABoolAndAnIntegerAreReadAsSet() =>
        Gives([1, -7, 1], "bool flag; int i; bool2 both;", "_Result[0] = flag ? 1 : 0; _Result[1] = i; _Result[2] = all(both) ? 1 : 0;", shader =>
        {
            shader.SetBool("flag", true);
            shader.SetInt("i", -7);
            shader.SetInts("both", 1, 1);
        });
}
