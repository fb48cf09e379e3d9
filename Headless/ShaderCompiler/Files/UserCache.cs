namespace Headless.Files;

/// <summary>Where what can be made again stays between runs, of the player and of setup.sh.</summary>
public static class UserCache
{
    /// <summary>In the user's folder of caches.</summary>
    public static string Folder { get; } = Below(Environment.GetEnvironmentVariable("XDG_CACHE_HOME") is { Length: > 0 } caches ? caches
        : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".cache"));

    /// <summary>Where a process keeps it whose XDG_CACHE_HOME is the folder given.</summary>
    public static string Below(string caches) => Path.Combine(caches, "sphplayer");
}
