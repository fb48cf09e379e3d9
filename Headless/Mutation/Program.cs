using Headless.Mutation;

try
{
    return new Campaign(Options.Parse(args)).Run();
}
catch (UsageException e)
{
    Console.Error.WriteLine($"mutate: {e.Message}");
    return 2;
}
