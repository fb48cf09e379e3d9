using System.Text;
using Headless.Files;
using Headless.Player.Commands;
using Headless.Player.Output;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Player;

public static class Program
{
    private const int Failed = 1;
    private const int WrongUsage = 2;

    // For scripts that refuse a word: sphplayer nearest WORD KNOWN...
    private const string Nearest = "nearest";

    private static readonly (string Name, string Summary, IReadOnlyList<Flag> Flags)[] commands =
    [
        ("play", "plays a scene; --project and --scene are needed; words behind a lone -- are the project's", PlayOptions.Flags),
        ("test", "runs the project's tests; --project is needed", TestOptions.Flags),
        ("exec", "calls a static method of the project; --project and --executeMethod are needed", ExecOptions.Flags),
        ("devices", "lists the graphics devices", []),
    ];

    public static int Main(string[] words)
    {
        GuardedConsole.Begin();
        return GuardedConsole.End(Run(words));
    }

    private static int Run(string[] words)
    {
        try
        {
            if (words.Length == 0) throw new UsageException("a command is missing: play, test, exec or devices.");
            string[] rest = words[1..];
            if (words[0] is not ("help" or "--help" or "-h" or Nearest)) CacheFolder.Check();
            switch (words[0])
            {
                case "play": return PlayCommand.Run(PlayOptions.Parse(rest));
                case "test": return TestCommand.Run(TestOptions.Parse(rest));
                case "exec": return ExecCommand.Run(ExecOptions.Parse(rest));
                case "devices": return DevicesCommand.Run(rest);
                case "help" or "--help" or "-h":
                    Console.Write(Usage());
                    return 0;
                case Nearest when words.Length > 1:
                    Console.Write(Suggestion.Question(words[1], words[2..]));
                    return 0;
                default:
                    string[] names = [.. commands.Select(c => c.Name)];
                    throw new UsageException($"'{OneLine.Value(words[0])}' is not a command{Suggestion.Question(words[0], names)} {string.Join(", ", names)} are.");
            }
        }
        catch (Exception e) when (e is UsageException or UnknownAdapterException or BadFileException)
        {
            return Fail(e.Message, WrongUsage);
        }
        catch (Exception e) when (e is ShaderCompilerMissingException or GpuException or IOException or UnauthorizedAccessException)
        {
            return Fail(e.Message, Failed);
        }
        catch (Exception e)
        {
            return Fail(FaultLog.Write(e, words), Failed);
        }
    }

    private static string Usage()
    {
        var text = new StringBuilder();
        foreach (var (name, summary, flags) in commands)
        {
            HelpColumns.Entry(text, "sphplayer " + name, summary);
            foreach (Flag flag in flags) HelpColumns.Flag(text, flag);
        }
        return text.ToString();
    }

    private static int Fail(string message, int code)
    {
        Console.Error.WriteLine(Message.Of(OneLine.Message(message)));
        return code;
    }
}
