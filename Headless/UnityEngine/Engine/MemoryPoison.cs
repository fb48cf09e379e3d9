namespace Headless.Engine;

/// <summary>Whether memory that Unity leaves uninitialised holds set bits (NaN as a float) in place of zeros; the device says so.</summary>
internal static class MemoryPoison
{
    public static bool Enabled { get; set; }
}
