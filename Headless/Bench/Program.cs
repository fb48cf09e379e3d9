using Headless.Bench;
using Headless.Bench.Scene;

try
{
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
