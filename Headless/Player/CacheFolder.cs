using System.Runtime.InteropServices;
using Headless.Files;

namespace Headless.Player;

/// <summary>Whether <see cref="UserCache.Folder"/> can be used.</summary>
internal static partial class CacheFolder
{
    /// <summary>Mesa maps an index of 1.3 MB beside our folder into memory: on a full disk the process would end by SIGBUS.</summary>
    private const long LeastFreeBytes = 16 << 20;

    private static readonly string[] mesaDoesWithout = ["MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"];

    /// <summary>Says in a line that the folder cannot be written; then the driver does without a cache, and shaders that the folder lacks are compiled in each run.</summary>
    public static void Check()
    {
        try
        {
            Directory.CreateDirectory(UserCache.Folder);
            using (new FileStream(Path.Combine(UserCache.Folder, "writable-" + Environment.ProcessId), FileMode.Create, FileAccess.Write, FileShare.None, 1, FileOptions.DeleteOnClose)) { }
            long free = new DriveInfo(UserCache.Folder).AvailableFreeSpace;
            if (free < LeastFreeBytes) throw new IOException($"{free >> 10} KB are free, of {LeastFreeBytes >> 10} that it needs.");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            Console.Error.WriteLine(Message.Of(OneLine.Message($"the cache folder '{UserCache.Folder}' cannot be written, so shaders are compiled in each run: {e.Message}")));
            // The driver reads the process's own environment, of which .NET has a copy.
            if (OperatingSystem.IsWindows()) return;
            foreach (string name in mesaDoesWithout) SetEnvironment(name, "true", 1);
        }
    }

    [LibraryImport("libc", EntryPoint = "setenv", StringMarshalling = StringMarshalling.Utf8)]
    private static partial int SetEnvironment(string name, string value, int overwrite);
}
