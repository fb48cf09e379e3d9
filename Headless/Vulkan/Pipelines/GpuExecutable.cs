namespace Headless.Vulkan;

/// <summary>One program that the driver's compiler made of a pipeline: figures and listing as the driver gives them.</summary>
/// <param name="Name">The driver's name, for example "Compute Shader".</param>
/// <param name="SubgroupSize">Lanes of a wave.</param>
/// <param name="Statistics">The driver's figures by its names, for example "VGPRs".</param>
/// <param name="Listings">The driver's texts by its names, for example "Assembly".</param>
public sealed record GpuExecutable(
    string Name, int SubgroupSize, IReadOnlyDictionary<string, double> Statistics, IReadOnlyDictionary<string, string> Listings);
