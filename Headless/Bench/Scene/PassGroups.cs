namespace Headless.Bench.Scene;

internal enum PassGroup
{
    Solver,
    Surface,
    Drawing,
}

/// <summary>Which part of a frame a pass belongs to, by its name.</summary>
internal static class PassGroups
{
    private static readonly string[] surfaceWords = ["Surface", "Blocks", "MCGrid"];
    private static readonly string[] drawingWords = ["Camera.", "Thickness", "Water", "Draw"];

    /// <summary>What is neither surface nor drawing is the solver's.</summary>
    public static PassGroup Of(string pass)
    {
        // SurfaceDrawArguments and the like.
        if (surfaceWords.Any(pass.Contains)) return PassGroup.Surface;
        return drawingWords.Any(word => pass.StartsWith(word, StringComparison.Ordinal)) ? PassGroup.Drawing : PassGroup.Solver;
    }
}
