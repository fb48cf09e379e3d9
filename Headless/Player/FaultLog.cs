using System.Globalization;

namespace Headless.Player;

/// <summary>What a fault of the player itself leaves for those who mend it; on the console it is one line.</summary>
internal static class FaultLog
{
    private const string FileName = "sphplayer-fault.log";

    /// <returns>The line for the console.</returns>
    public static string Write(Exception fault, IReadOnlyList<string> words)
    {
        string what = Files.OneLine.Value($"{fault.GetType().Name}: {fault.Message}");
        string file = Path.Combine(Path.GetTempPath(), FileName);
        try
        {
            File.WriteAllText(file, string.Create(CultureInfo.InvariantCulture,
                $"{DateTime.UtcNow:u} {Environment.OSVersion} .NET {Environment.Version}\nsphplayer {string.Join(' ', words)}\n{fault}\n"));
            return $"this is a fault of the player itself ({what}). Please report it to those you have the package from, with the file {file}.";
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return $"this is a fault of the player itself ({what}), and {file} could not be written. Please report it to those you have the package from.";
        }
    }
}
