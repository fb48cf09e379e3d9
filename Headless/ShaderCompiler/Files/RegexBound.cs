using System.Runtime.CompilerServices;

namespace Headless.Files;

/// <summary>Expressions over sources of a project give up in time: a pattern that is quick on shaders may not be on what somebody broke.</summary>
internal static class RegexBound
{
    private const string Name = "REGEX_DEFAULT_MATCH_TIMEOUT";

    // Only the first expression of a process reads it.
#pragma warning disable CA2255
    [ModuleInitializer]
#pragma warning restore CA2255
    public static void Set()
    {
        if (AppContext.GetData(Name) is null) AppDomain.CurrentDomain.SetData(Name, TimeSpan.FromSeconds(3));
    }
}
