using Headless.Mutation;

try
{
    if (args.Contains("--help") || args.Contains("-h"))
    {
        Console.WriteLine(Options.Usage);
        return 0;
    }
    return new Campaign(Options.Parse(args)).Run();
}
catch (UsageException e)
{
    Console.Error.WriteLine($"mutate: {e.Message}");
    return 2;
}
