namespace Headless.Shaders.SpirV;

/// <summary>A user-defined input or output of a stage.</summary>
/// <param name="Semantic">Canonical: upper case, index 0 left out save for TEXCOORD0.</param>
/// <param name="Elements">Array elements that carry consecutive semantic indices; 1 for no array.</param>
/// <param name="Rows">Locations an element takes: 1, or the columns of a SPIR-V matrix.</param>
/// <param name="Scalar">float, int or uint.</param>
internal sealed record StageVariable(uint Id, string Semantic, int Elements, int Rows, int Components, string Scalar)
{
    public int Locations => Elements * Rows;
}
