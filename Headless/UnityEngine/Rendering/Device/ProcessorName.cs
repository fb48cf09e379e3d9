using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;

namespace UnityEngine;

/// <summary>The processor's own name, as Linux has it; elsewhere, and where the kernel gives none, the architecture.</summary>
internal static class ProcessorName
{
    private const string Cpus = "/proc/cpuinfo";

    public static string Value { get; } = Find(File.Exists(Cpus) ? File.ReadAllText(Cpus) : "") ?? RuntimeInformation.ProcessArchitecture.ToString();

    /// <summary>The name in the text of /proc/cpuinfo; null where it has none.</summary>
    internal static string? Find(string cpus) =>
        cpus.Split('\n').Select(line => line.Split(':', 2)).FirstOrDefault(parts => parts.Length == 2 && parts[0].Trim() == "model name")?[1].Trim();
}
