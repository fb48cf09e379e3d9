using Headless.Measure;
using Headless.Measure.Children;

// Each part is a process of its own, of this same program: with any other first word than a flag it is the player.
if (args is [FakeFault.Word, var fault]) return FakeFault.Be(fault);
if (args is [var first, ..] && !first.StartsWith('-')) return Headless.Player.Program.Main(args);
if (args.Any(word => word is "--help" or "-h"))
{
    Console.Write(MeasureOptions.Help);
    return 0;
}
try
{
    MeasureOptions options = MeasureOptions.Parse(args);
    return options.Page is { } folder ? MeasurementPage.WriteAgain(folder, options.Place) : new Measurement(options).Run();
}
catch (UsageException e)
{
    Console.Error.WriteLine($"measure: {e.Message}");
    return 2;
}
catch (Exception e) when (e is IOException or UnauthorizedAccessException)
{
    Console.Error.WriteLine($"measure: {e.Message}");
    return 1;
}
