namespace Headless.Player;

/// <summary>What a run does to show the use of uninitialised memory and accesses outside buffers.</summary>
/// <param name="Poison">New buffers, textures, groupshared and native memory hold set bits in place of zeros.</param>
/// <param name="Bounds">No robust access; every index of a shader is checked.</param>
public sealed record MemoryChecks(bool Poison, bool Bounds)
{
    /// <summary>Any verb takes them from here: "poison", "bounds" or "poison,bounds".</summary>
    public const string Variable = "SPHPLAYER_MEMORY";

    /// <exception cref="UsageException">The variable holds another word.</exception>
    public static MemoryChecks FromEnvironment()
    {
        string[] words = (Environment.GetEnvironmentVariable(Variable) ?? "")
            .Split(',', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        if (words.FirstOrDefault(word => word is not ("poison" or "bounds")) is { } unknown)
        {
            throw new UsageException($"the environment variable {Variable} holds '{unknown}'; 'poison', 'bounds' and 'poison,bounds' are understood.");
        }

        return new MemoryChecks(words.Contains("poison"), words.Contains("bounds"));
    }

    public override string ToString() =>
        (Poison ? ", new memory poisoned" : "") + (Bounds ? ", no robust access, every index checked" : "");
}
