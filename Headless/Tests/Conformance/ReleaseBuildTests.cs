using System.Diagnostics;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Xml.Linq;
using NUnit.Framework;

namespace Headless.Tests.Conformance;

/// <summary>What the player runs is optimised code.</summary>
public sealed class ReleaseBuildTests
{
    private static string Root => FindUp("Headless/Play.slnx");

    /// <summary>The player's own folder, and the scripts beside it that ./run gathers.</summary>
    [Test]
    public void EveryAssemblyThatThePlayerLoadsIsOptimised()
    {
        string player = Path.Combine(Root, "Build", "dotnet", "bin", "Headless.Player", "release");
        string scripts = Path.Combine(Root, "Build", "ScriptAssemblies");
        if (!Directory.Exists(player))
        {
            Assert.Ignore($"'{player}' is missing: ./run build makes it");
        }

        string[] files = [.. new[] { player, scripts }.Where(Directory.Exists).SelectMany(f => Directory.GetFiles(f, "*.dll"))];
        Assert.That(files, Has.Length.GreaterThan(8));
        Assert.That(files.Where(f => !IsOptimised(f)).Select(Path.GetFileName), Is.Empty);
    }

    /// <summary>MSBuild may build a project that a solution does not list as Debug.</summary>
    [Test]
    public void TheSolutionOfAPlainRunListsEveryProjectThatItBuilds()
    {
        string headless = Path.Combine(Root, "Headless");
        HashSet<string> listed = [.. XDocument.Load(Path.Combine(headless, "Play.slnx")).Descendants("Project")
            .Select(p => Path.GetFullPath(Path.Combine(headless, p.Attribute("Path")!.Value)))];
        IEnumerable<string> references = listed.SelectMany(project => XDocument.Load(project).Descendants("ProjectReference")
            .Select(r => r.Attribute("Include")!.Value).Where(r => !r.Contains("$("))
            .Select(r => Path.GetFullPath(Path.Combine(Path.GetDirectoryName(project)!, r))));
        Assert.That(references.Where(r => !listed.Contains(r)).Distinct(), Is.Empty);
    }

    // DebuggableAttribute(DebuggingModes): two bytes of prolog, then the modes.
    private static bool IsOptimised(string file)
    {
        using PEReader reader = new(File.OpenRead(file));
        if (!reader.HasMetadata)
        {
            return true;
        }

        MetadataReader metadata = reader.GetMetadataReader();
        foreach (CustomAttributeHandle handle in metadata.GetAssemblyDefinition().GetCustomAttributes())
        {
            CustomAttribute attribute = metadata.GetCustomAttribute(handle);
            if (attribute.Constructor.Kind == HandleKind.MemberReference
                && metadata.GetMemberReference((MemberReferenceHandle)attribute.Constructor).Parent is { Kind: HandleKind.TypeReference } parent
                && metadata.GetString(metadata.GetTypeReference((TypeReferenceHandle)parent).Name) == nameof(DebuggableAttribute))
            {
                BlobReader blob = metadata.GetBlobReader(attribute.Value);
                blob.ReadUInt16();
                return ((DebuggableAttribute.DebuggingModes)blob.ReadInt32() & DebuggableAttribute.DebuggingModes.DisableOptimizations) == 0;
            }
        }

        return true;
    }

    internal static string FindUp(string relative)
    {
        for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
        {
            if (File.Exists(Path.Combine(folder.FullName, relative)))
            {
                return folder.FullName;
            }
        }

        throw new FileNotFoundException($"{relative} is not above {AppContext.BaseDirectory}");
    }
}
