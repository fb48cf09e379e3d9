using Headless.Files;
using Headless.Player;
using Headless.Shaders;
using NUnit.Framework;

namespace Headless.Tests.Shaders;

/// <summary>Direct3D's compiler for tests; they are skipped where it is not installed.</summary>
internal static class Direct3DTools
{
    /// <summary>Started once for all tests.</summary>
    private static readonly Lazy<Direct3DFrontEnd> shared = new(() =>
    {
        Direct3DFrontEnd compiler = new(UserCache.Folder);
        AppDomain.CurrentDomain.ProcessExit += (_, _) => compiler.Dispose();
        return compiler;
    });

    public static Direct3DFrontEnd Require()
    {
        if (shared.Value.Missing is { } missing)
        {
            Assert.Ignore(missing);
        }
        return shared.Value;
    }
}
