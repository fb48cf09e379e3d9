using System.Runtime.InteropServices;

namespace Headless.Measure.Children;

/// <summary>A child process that goes wrong, for rehearsals of what follows.</summary>
internal static class FakeFault
{
    public const string Word = "fake-fault";

    public static IReadOnlyList<string> Names { get; } = ["hang", "deaf", "crash", "memory"];

    public static int Be(string fault)
    {
        Console.WriteLine($"this part {fault} as it was asked to");
        switch (fault)
        {
            case "hang":
                Thread.Sleep(Timeout.Infinite);
                return 0;
            case "deaf":
                using (PosixSignalRegistration.Create(PosixSignal.SIGINT, signal => signal.Cancel = true)) Thread.Sleep(Timeout.Infinite);
                return 0;
            case "memory":
                Console.Error.WriteLine("vkAllocateMemory: the device's memory is full: use fewer or smaller buffers and textures");
                return 1;
            default:
                Environment.FailFast("a crash");
                return 0;
        }
    }
}
