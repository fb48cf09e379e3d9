using System.Text.RegularExpressions;
using Headless.Player;
using Headless.Player.Commands;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>Every flag of the player with every kind of wrong value: one line that names the flag. The package has the same table for its verbs.</summary>
public sealed partial class FlagTableTests
{
    private static readonly string[] NoNumbers = ["", " ", "-1", "0", "NaN", "Infinity", "-Infinity", "1e400", "1e-30", "0x10", "1_000", "99999999999999999999999", "many"];
    private static readonly string[] NoSizes = ["", "1280", "0x0", "-1x5", "1e3x5", "99999x1", "16384x16384", "axb", "1x2x3"];
    private static readonly string[] NoFolders = ["", " ", "/no/such/folder", "\n"];
    private static readonly string[] NoScenes = ["", " ", "a.txt", "a"];
    private static readonly string[] Nothing = ["", " "];
    private static readonly string[] NoStereo = ["", "both", "Instanced"];
    private static readonly string[] NoPipelines = ["", "urp", "Universal", "builtin"];
    private static readonly string[] NoModes = ["", "editor", "-1"];

    private static readonly (string Command, string[] Needed, Action<string[]> Parse, (string Flag, string[] Wrong)[] Flags, string[] Switches)[] Commands =
    [
        ("play", ["--project", ".", "--scene", "a.unity"], w => PlayOptions.Parse(w),
            [("--seconds", NoNumbers), ("--fps", NoNumbers), ("--size", NoSizes), ("--assemblies", NoFolders), ("--out", Nothing), ("--device", Nothing), ("--pipeline", NoPipelines), ("--stereo", NoStereo), ("--executeMethod", Nothing)],
            ["--no-images", "--open", "--twice", "--validate"]),
        ("play", ["--project", "."], w => PlayOptions.Parse(w), [("--scene", NoScenes)], []),
        ("play", ["--scene", "a.unity"], w => PlayOptions.Parse(w), [("--project", NoFolders)], []),
        ("test", ["--project", "."], w => TestOptions.Parse(w), [("--assemblies", NoFolders), ("--mode", NoModes), ("--filter", Nothing), ("--twice", Nothing), ("--device", Nothing), ("--pipeline", NoPipelines)], ["--validate"]),
        ("exec", ["--project", ".", "--executeMethod", "A.B"], w => ExecOptions.Parse(w), [("--assemblies", NoFolders), ("--device", Nothing), ("--pipeline", NoPipelines)], ["--validate"]),
        ("exec", ["--project", "."], w => ExecOptions.Parse(w), [("--executeMethod", Nothing)], []),
    ];

    private static IEnumerable<TestCaseData> Rows() =>
        from command in Commands
        from flag in command.Flags
        from wrong in flag.Wrong
        from words in new[] { new[] { flag.Flag, wrong }, [flag.Flag + "=" + wrong] }
        select new TestCaseData(command.Parse, flag.Flag, command.Needed.Concat(words).ToArray())
            .SetName($"AWrongValue({command.Command} {string.Join(' ', words).Replace("\n", "newline")})");

    private static IEnumerable<TestCaseData> Alone() =>
        from command in Commands
        from flag in command.Flags
        select new TestCaseData(command.Parse, flag.Flag, command.Needed.Append(flag.Flag).ToArray()).SetName($"AFlagWithoutValue({command.Command} {flag.Flag})");

    private static IEnumerable<TestCaseData> Twice() =>
        from command in Commands
        from flag in command.Switches
        select new TestCaseData(command.Parse, flag, command.Needed.Concat([flag, flag]).ToArray()).SetName($"ASwitchTwice({command.Command} {flag})");

    private static IEnumerable<TestCaseData> Unknown() =>
        from command in Commands
        select new TestCaseData(command.Parse, "--spead", command.Needed.Concat(["--spead", "1"]).ToArray())
            .SetName($"AnUnknownFlag({command.Command} beside {string.Join(' ', command.Needed)})");

    [TestCaseSource(nameof(Rows))]
    [TestCaseSource(nameof(Alone))]
    [TestCaseSource(nameof(Twice))]
    [TestCaseSource(nameof(Unknown))]
    public void IsOneLine(Action<string[]> parse, string flag, string[] words)
    {
        var exception = Assert.Throws<UsageException>(() => parse(words))!;
        Assert.That(exception.Message, Does.Contain(flag));
        Assert.That(exception.Message, Does.Not.Contain("\n"));
        Assert.That(exception.Message.Length, Is.LessThan(1000));
    }

    [TestCase("play")]
    [TestCase("test")]
    [TestCase("exec")]
    public void TheUsageNamesEveryFlag(string command)
    {
        var (_, needed, parse, _, _) = Commands.First(c => c.Command == command);
        string message = Assert.Throws<UsageException>(() => parse([.. needed, "--spead"]))!.Message;
        string[] flags = [.. Flag().Matches(message[message.IndexOf("Its flags are", StringComparison.Ordinal)..]).Select(m => m.Value)];
        string help = PlayerProcess.Run("help").Output;
        string[] all = ["sphplayer play", "sphplayer test", "sphplayer exec", "sphplayer devices"];
        int begin = help.IndexOf("sphplayer " + command, StringComparison.Ordinal);
        int end = all.Select(c => help.IndexOf(c, StringComparison.Ordinal)).Where(i => i > begin).Min();
        string[] named = [.. Flag().Matches(help[begin..end]).Select(m => m.Value).Distinct()];
        Assert.That(flags, Has.Length.GreaterThan(4));
        Assert.That(named, Is.EquivalentTo(flags));
    }

    [GeneratedRegex("--[A-Za-z][A-Za-z-]*")]
    private static partial Regex Flag();
}
