using Headless.Checks.Shaders;

namespace Headless.Checks.Buffers;

/// <summary>What a user switches on or off, and the shaders that come with it.</summary>
/// <param name="Has">Whether a shader variant belongs to it; the first part of the list that has it counts.</param>
internal sealed record BufferPart(string Name, Func<ShaderVariant, bool> Has)
{
    private const string Cells = "Shaders/Solver/Cells/", Standard = "Shaders/Solver/Standard/", Robust = "Shaders/Solver/Robust/";

    public static IReadOnlyList<BufferPart> All { get; } =
    [
        new("forces on walls", v => With(v, "FLUID_WALL_FORCES") || In(v, "Shaders/Solver/WallForces/")),
        new("gradient correction", v => In(v, Standard + "GradientCorrection/") || With(v, "FLUID_GRADIENT_CORRECTION", "FLUID_CARRIES_BESIDES")),
        new("surface tension", v => In(v, Standard + "Tension/")),
        new("implicit viscosity", v => In(v, Standard + "Viscosity/")),
        new("floating bodies", v => With(v, "FLUID_FLOATING_BODIES") || Is(v, "MoveBodies")),
        new("force zones", v => With(v, "FLUID_ZONES")),
        new("emitters and drains", v => Is(v, "BirthParticles", "DrainParticles", "GrowParticles")),
        new("Robust with colliders", v => In(v, Robust) && With(v, "FLUID_MESH_WALLS")),
        new("Robust", v => In(v, Robust) || With(v, "FLUID_CARRIES")),
        new("colliders: walls and contact", v => Is(v, "GatherWalls", "FindContacts", "ResolveContacts")),
        new("Standard with colliders", v => In(v, Standard) && With(v, "FLUID_MESH_WALLS")),
        new("Standard, and what Playback shows", v => In(v, Standard) || In(v, Cells) || In(v, "Shaders/Simulation/")),
        new("Thesis", v => In(v, "Thesis/Shaders/Solver/")),
        new("Thesis's surface", v => In(v, "Thesis/Shaders/Surface/")),
        new("surface", v => In(v, "Shaders/Surface/")),
        new("drawing particles, surface and water", v => In(v, "Shaders/Rendering/")),
        new("whitewater", v => In(v, "Shaders/Whitewater/")),
        new("queries", v => In(v, "Shaders/Queries/")),
        new("diagnostics", v => In(v, "Shaders/Diagnostics/")),
        new("samples", v => In(v, "Samples~/")),
        new("measurements of the validation package", _ => true),
    ];

    public static BufferPart Of(ShaderVariant variant) => All.First(part => part.Has(variant));

    private static bool In(ShaderVariant variant, string folder) => variant.File.StartsWith(folder, StringComparison.Ordinal);

    private static bool Is(ShaderVariant variant, params string[] names) => names.Contains(Path.GetFileNameWithoutExtension(variant.File));

    private static bool With(ShaderVariant variant, params string[] keywords) => keywords.Any(variant.Request.Keywords.Contains);
}
