using NUnit.Framework;

namespace Headless.Tests.Conformance;

/// <summary>Scope of loop variables: the expected values are those of FXC's listings (warning X3078 where names repeat).</summary>
public sealed class LoopTests : HlslFixture
{
    [Test]
    public void TwoLoopsMayDeclareTheSameVariable() =>
        Gives([3, 4], "", "for (int i = 0; i < 3; i++) _Result[0] += 1; for (int i = 0; i < 4; i++) _Result[1] += 1;");

    [Test]
    public void ALoopVariableLivesOnAfterTheLoop() =>
        Gives([3, 9], "", "for (int i = 0; i < 3; i++) {} _Result[0] = i; i = 9; _Result[1] = i;");

    [Test]
    public void TheMostRecentLoopVariableCounts() =>
        Gives([4, 3], "", "for (int i = 0; i < 3; i++) {} for (int i = 0; i < 4; i++) {} _Result[0] = i; int k = 7; for (int k = 0; k < 3; k++) {} _Result[1] = k;");

    [Test]
    public void ALoopVariableOfAnotherTypeTakesItsPlace() =>
        Gives([1], "", "for (float i = 0; i < 3; i++) {} for (int i = 0; i < 4; i++) {} _Result[0] = i / 3;");

    [Test]
    public void ALoopVariableOfAnInnerBlockEndsWithIt() =>
        Gives(
            [2, 3, 3, 5, 3], "",
            "for (int i = 0; i < 3; i++) { [unroll] for (int j = 0; j < 2; j++) {} _Result[0] = j; } _Result[1] = i; "
            + "{ _Result[2] = i; for (uint i = 0; i < 5; i++) {} _Result[3] = i; } _Result[4] = i;");

    [Test]
    public void AttributesOfLoopsAndBranchesAreAccepted() =>
        Gives(
            [6, 10, 2, 1], "int n;",
            "[unroll] for (int i = 0; i < 4; i++) _Result[0] += i; [loop] for (int j = 0; j < n; j++) _Result[1] += j; "
            + "[branch] if (n > 3) _Result[2] = 2; [flatten] if (n > 4) _Result[3] = 1; [unroll(3)] for (int k = 0; k < 3; k++) {} "
            + "[fastopt] while (n < 0) { break; } [forcecase] switch (n) { case 0: break; default: break; }", shader => shader.SetInt("n", 5));

    [Test]
    public void WhileDoContinueAndSwitchRun() =>
        Gives(
            [3, 4, 5, 30], "",
            "int a = 0; while (true) { if (++a == 3) break; } _Result[0] = a; int b = 0; do { b++; } while (b < 4); _Result[1] = b; "
            + "for (int i = 0; i < 10; i++) { if (i % 2) continue; _Result[2] += 1; } "
            + "switch (a) { case 1: _Result[3] = 10; break; case 2: case 3: _Result[3] = 30; break; default: _Result[3] = 40; break; }");
}
