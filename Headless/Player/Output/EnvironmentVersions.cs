using System.ComponentModel;
using System.Diagnostics;
using System.Runtime.InteropServices;

namespace Headless.Player.Output;

/// <summary>What a run's figures depend on besides the project: system, .NET and the versions of the Debian packages in use.</summary>
public static class EnvironmentVersions
{
    private static readonly TimeSpan limit = TimeSpan.FromSeconds(5);

    private static readonly string[] packages =
    [
        "ffmpeg", "glslang-tools", "gnuplot-nox", "libvulkan1", "mesa-vulkan-drivers", "spirv-cross", "spirv-tools",
        "vulkan-validationlayers", "wine64",
    ];

    /// <summary>"os", "dotnet" and each package that is installed; without dpkg the first two.</summary>
    public static IReadOnlyList<(string Key, string Version)> Read() =>
        [("os", RuntimeInformation.OSDescription), ("dotnet", Environment.Version.ToString()), .. Packages("dpkg-query")];

    /// <param name="program">dpkg-query, which lists what is installed, says on its error output what is not, and ends with 1 then.</param>
    internal static IReadOnlyList<(string Key, string Version)> Packages(string program)
    {
        const string format = "${db:Status-Status} ${Package} ${Version}\\n";
        try
        {
            using Process process = Process.Start(new ProcessStartInfo(program, ["-W", "-f", format, .. packages])
            {
                RedirectStandardOutput = true, RedirectStandardError = true,
            })!;
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            _ = process.StandardError.ReadToEndAsync();
            if (!process.WaitForExit(limit) || !output.Wait(limit)) return [];
            return Parse(output.Result);
        }
        catch (Win32Exception)
        {
            return [];
        }
    }

    /// <summary>Lines such as "installed libvulkan1 1.3.239.0-1"; packages that were removed have another first word.</summary>
    internal static IReadOnlyList<(string Key, string Version)> Parse(string output) =>
    [
        .. from line in output.Split('\n')
           let words = line.Split(' ')
           where words.Length == 3 && words[0] == "installed"
           orderby words[1]
           select (words[1], words[2]),
    ];
}
