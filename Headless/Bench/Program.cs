using Headless.Bench;
using Headless.Bench.Model;
using Headless.Bench.Scene;

try
{
    if (args.Length > 1 && args[1] == "model") return ModelCommand.Run(args[0], args[2..]);
    return new SceneBench(SceneOptions.Parse(args)).Run();
}
catch (UsageException e)
{
    Console.Error.WriteLine($"bench: {e.Message}");
    return 2;
}
catch (PlayerFailedException e)
{
    Console.Error.WriteLine($"bench: {e.Message}");
    return 1;
}
