using Headless.Files;
using Headless.Player.Commands;
using Headless.Shaders;
using Headless.Vulkan;

namespace Headless.Player;

public static class Program
{
    private const int Failed = 1;
    private const int WrongUsage = 2;

    private const string Usage = """
        sphplayer play --project DIR --scene FILE.unity [--assemblies DIR] [--seconds S] [--fps F] [--size WxH] [--out DIR]
                       [--device NAME|INDEX] [--no-images] [--validate] [--executeMethod Class.Method] [-- words for the project]
        sphplayer test --project DIR [--assemblies DIR] [--mode edit|play|all] [--filter TEXT | --tests FILE]
                       [--stop-on-fail] [--again] [--coverage FILE] [--compiler glslang|fxc] [--device NAME|INDEX] [--validate]
                       [--poison] [--check-bounds]
        sphplayer exec --project DIR --executeMethod Class.Method [--assemblies DIR] [--device NAME|INDEX] [--validate] [-- words]
        sphplayer devices
        """;

    public static int Main(string[] words)
    {
        try
        {
            if (words.Length == 0) throw new UsageException("a command is missing: play, test, exec or devices.");
            string[] rest = words[1..];
            switch (words[0])
            {
                case "play": return PlayCommand.Run(PlayOptions.Parse(rest));
                case "test": return TestCommand.Run(TestOptions.Parse(rest));
                case "exec": return ExecCommand.Run(ExecOptions.Parse(rest));
                case "devices": return DevicesCommand.Run(rest);
                case "help" or "--help" or "-h":
                    Console.WriteLine(Usage);
                    return 0;
                default: throw new UsageException($"'{words[0]}' is not a command: play, test, exec and devices are.");
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

    private static int Fail(string message, int code)
    {
        Console.Error.WriteLine("sphplayer: " + OneLine.Message(message));
        return code;
    }
}
