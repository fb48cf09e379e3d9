namespace SphFluid
{
    /// <summary>What is asked; in the order of their answers.</summary>
    internal enum QueryKind
    {
        Point,
        Ray,
        Box,
        Nearest,
        Patch,
    }
}
