using Headless.Checks.Gpu;
using NUnit.Framework;

namespace Headless.Tests.Checks;

public sealed class IsaListingTests
{
    private const string Nested = """
        Shader main:
        BB0:
        	s_mov_b32 s0, 0                                       ; be800380
        BB1:
        	v_mul_f32_e32 v1, v2, v3                              ; 10020702
        BB2:
        	buffer_load_dwordx3 v[4:6], v0, s[4:7], 0 offen       ; e03c1000 80010400
        	s_waitcnt vmcnt(0)                                    ; bf8c3f70
        	v_rcp_f32_e32 v7, v6                                  ; 7e0e5506
        	v_mul_lo_u32 v8, v7, v6                               ; d5690008 00020d07
        	s_cbranch_vccnz BB2                                   ; bf86fffa
        	v_add_f32_e32 v9, v9, v7                              ; 06120f09
        	s_cbranch_scc1 BB1                                    ; bf85fff0
        BB3:
        	s_nop 0                                               ; bf800000
        	(then repeated 2 times)
        	s_cbranch_execz BB4                                   ; bf880001
        BB4:
        	s_endpgm                                              ; bf810000
        """;

    [Test]
    public void OnlyTheLoopThatContainsNoOtherIsCounted()
    {
        InstructionCounts loop = IsaListing.Parse(Nested).InnerLoops().Single();

        Assert.That(loop, Is.EqualTo(new InstructionCounts(
            Valu: 0, Transcendental: 1, IntegerProduct: 1, Scalar: 0, Branches: 1, ScalarLoads: 0, VectorLoads: 1, VectorStores: 0,
            Atomics: 0, Groupshared: 0, Waits: 1)));
        Assert.That(loop.Total, Is.EqualTo(5));
    }

    [Test]
    public void RepeatedInstructionsCountAsOftenAsTheyAreRepeated() =>
        Assert.That(IsaListing.Parse(Nested).Operations.Count(o => o == "s_nop"), Is.EqualTo(3));

    [Test]
    public void SeveralJumpsBackToOnePlaceAreOneLoop()
    {
        const string text = "BB1:\n\tv_nop\n\ts_cbranch_scc0 BB1 ; 1\n\tv_nop\n\ts_branch BB1 ; 2\n";

        Assert.That(IsaListing.Parse(text).InnerLoops().Select(l => l.Total), Is.EqualTo(new[] { 4 }));
    }

    [Test]
    public void AJumpForwardIsNoLoop() => Assert.That(IsaListing.Parse("\ts_branch BB1 ; 1\nBB1:\n\ts_endpgm\n").InnerLoops(), Is.Empty);

    [Test]
    public void CyclesAreThoseOfTheFamily()
    {
        var counts = InstructionCounts.Of(["v_add_f32_e32", "v_sqrt_f32_e32", "v_mul_hi_u32", "ds_read_b32", "s_add_u32", "s_waitcnt"]);

        Assert.That(GpuFamily.All.Select(f => f.Cycles(counts)), Is.EqualTo(new[] { 20, 40, 20, 40 }));
    }

    [TestCase("s_buffer_load_dword", InstructionClass.ScalarLoad)]
    [TestCase("s_barrier", InstructionClass.Wait)]
    [TestCase("s_and_saveexec_b64", InstructionClass.Scalar)]
    [TestCase("buffer_store_dwordx2", InstructionClass.VectorStore)]
    [TestCase("buffer_atomic_add", InstructionClass.Atomic)]
    [TestCase("global_load_dword", InstructionClass.VectorLoad)]
    [TestCase("image_sample", InstructionClass.VectorLoad)]
    [TestCase("scratch_load_dword", InstructionClass.VectorLoad)]
    [TestCase("exp", InstructionClass.VectorStore)]
    [TestCase("v_exp_f32_e32", InstructionClass.Transcendental)]
    [TestCase("v_mad_u32_u24", InstructionClass.Valu)]
    public void InstructionsAreClassed(string operation, InstructionClass expected) =>
        Assert.That(InstructionCounts.ClassOf(operation), Is.EqualTo(expected));

    [Test]
    public void AnUnknownInstructionIsAnError() =>
        Assert.That(() => InstructionCounts.ClassOf("tensor_mma"), Throws.TypeOf<FormatException>().With.Message.Contains("tensor_mma"));
}
