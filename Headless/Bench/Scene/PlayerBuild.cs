using System.Diagnostics;

namespace Headless.Bench.Scene;

/// <summary>A checkout of the repository with its built player.</summary>
internal sealed class PlayerBuild
{
    public PlayerBuild(string flag, string folder)
    {
        Folder = Path.GetFullPath(folder);
        if (!File.Exists(Player) || !Directory.Exists(Assemblies))
            throw new UsageException($"{flag}: '{folder}' has no built player. Build it there: (cd {folder} && ./run build Play.slnx).");
        Commit = ReadCommit();
    }

    public string Folder { get; }

    public string Player => Path.Combine(Folder, "Build/dotnet/bin/Headless.Player/release/sphplayer");

    public string Assemblies => Path.Combine(Folder, "Build/ScriptAssemblies");

    /// <summary>The checkout's commit, with a + where files differ from it; empty where git knows none.</summary>
    public string Commit { get; }

    /// <summary>This build's copy of a scene: a path below the folder of the build that was asked.</summary>
    public string SceneOf(string scene, PlayerBuild asked)
    {
        string path = Path.GetRelativePath(asked.Folder, Path.GetFullPath(scene));
        string own = Path.Combine(Folder, path);
        if (path.StartsWith("..", StringComparison.Ordinal) || !File.Exists(own))
            throw new UsageException($"--scene: '{own}' does not exist; a scene that is compared must be in both builds' folders.");
        return own;
    }

    private string ReadCommit()
    {
        string commit = Git("rev-parse", "--short", "HEAD");
        return commit.Length > 0 && Git("status", "--porcelain", "--untracked-files=no").Length > 0 ? commit + "+" : commit;
    }

    private string Git(params string[] words)
    {
        try
        {
            using Process git = Process.Start(new ProcessStartInfo("git", ["-C", Folder, .. words]) { RedirectStandardOutput = true, RedirectStandardError = true })!;
            string output = git.StandardOutput.ReadToEnd().Trim();
            git.WaitForExit();
            return git.ExitCode == 0 ? output : "";
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return "";
        }
    }
}
