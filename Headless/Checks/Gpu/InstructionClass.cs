namespace Headless.Checks.Gpu;

/// <summary>What issues an instruction of GCN or RDNA, and at what rate.</summary>
public enum InstructionClass
{
    Valu,
    Transcendental,
    IntegerProduct,
    Scalar,
    Branch,
    ScalarLoad,
    VectorLoad,
    VectorStore,
    Atomic,
    Groupshared,
    Wait,
}
