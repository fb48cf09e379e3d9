using System.Runtime.InteropServices;
using Headless.Measure.Children;

namespace Headless.Measure.Parts;

/// <summary>What there is to measure: the list of devices, and the machine.</summary>
internal static class DevicePart
{
    public static Part Part { get; } = new("device", "which devices are there", 5, 2, Run) { IsNeeded = true };

    private static PartOutcome Run(PartRun run)
    {
        ChildResult devices = run.Devices();
        string[] machine =
        [
            $"{RuntimeInformation.OSDescription}, {RuntimeInformation.OSArchitecture}",
            FormattableString.Invariant($"{Environment.ProcessorCount} processors, {GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / 1073741824.0:0.#} GiB of memory"),
        ];
        if (devices.Ending != ChildEnding.Done) return PartOutcome.Of(devices, machine);
        File.WriteAllLines(run.Results.In("devices.txt"), [.. devices.Tail, .. machine]);
        // NVIDIA's drivers bring a program that tells clocks and temperatures; it is a help and no more.
        string clocks = run.Results.In("nvidia-smi.txt");
        if (run.Tool(clocks, "nvidia-smi", "-q").Ending != ChildEnding.Done) File.Delete(clocks);
        return PartOutcome.Of(devices, [.. devices.Tail, .. machine]);
    }
}
