using System.Diagnostics;

namespace Headless.Checks.Gpu;

/// <summary>Runs this program again as a child whose environment makes RADV compile for a GPU that is not there.</summary>
internal sealed class NullHardware(string project, string shaderCache)
{
    private static readonly string[] driverFolders = ["/etc/vulkan/icd.d", "/usr/local/share/vulkan/icd.d", "/usr/share/vulkan/icd.d"];

    /// <summary>RADV's file for the Vulkan loader; null where the driver is not installed.</summary>
    public static string? DriverFile { get; } = driverFolders
        .Where(Directory.Exists).SelectMany(folder => Directory.GetFiles(folder, "radeon_icd*.json")).FirstOrDefault();

    public FamilyResult Compile(GpuFamily family)
    {
        using var process = Process.Start(Child(family))!;
        var errors = process.StandardError.ReadToEndAsync();
        var lines = new List<string>();
        while (process.StandardOutput.ReadLine() is { } line) lines.Add(line);
        process.WaitForExit();
        return FamilyResult.Read(family, lines, process.ExitCode, errors.Result.Trim());
    }

    private ProcessStartInfo Child(GpuFamily family)
    {
        string[] words = [project, "--compile-for", family.Name, "--shader-cache", shaderCache];
        var self = Path.GetFileName(Environment.ProcessPath) == "sphchecks"
            ? new ProcessStartInfo(Environment.ProcessPath, words)
            : new ProcessStartInfo("dotnet", [typeof(NullHardware).Assembly.Location, .. words]);
        (self.RedirectStandardOutput, self.RedirectStandardError) = (true, true);
        self.Environment["RADV_FORCE_FAMILY"] = family.Name;
        self.Environment["VK_DRIVER_FILES"] = self.Environment["VK_ICD_FILENAMES"] = DriverFile;
        // Mesa's own cache would bring programs without their figures, and its device chooser asks for a display.
        self.Environment["MESA_SHADER_CACHE_DISABLE"] = self.Environment["NODEVICE_SELECT"] = "true";
        self.Environment["XDG_RUNTIME_DIR"] = Path.GetTempPath();
        return self;
    }
}
