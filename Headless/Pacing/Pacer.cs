using System.Reflection;
using UnityEngine;

namespace Headless.Pacing;

/// <summary>
/// Lets another program say when a player may go on: before each frame it waits for a word on a socket. It is loaded as one more
/// script assembly, so players of earlier builds, which know nothing of it, can be paced too.
/// </summary>
public static class Pacer
{
    /// <summary>Environment variable: path of the socket.</summary>
    public const string SocketVariable = "SPHPACE_SOCKET";

    /// <summary>Environment variable: Namespace.Class.Method, which --executeMethod would have named without the pacer.</summary>
    public const string MethodVariable = "SPHPACE_METHOD";

    /// <summary>Environment variable: static properties, Namespace.Class.Property divided by commas, whose growth in a frame is reported.</summary>
    public const string CountersVariable = "SPHPACE_COUNTERS";

    private const BindingFlags Static = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic;

    /// <summary>For --executeMethod: paces what follows, and calls the method of <see cref="MethodVariable"/>.</summary>
    public static void Play()
    {
        string socket = Variable(SocketVariable) ?? throw new InvalidOperationException($"{SocketVariable} is not set: the pacer is started by ./run bench --table scene.");
        var counters = (Variable(CountersVariable) ?? "").Split(',', StringSplitOptions.RemoveEmptyEntries).Select(Counter).OfType<FrameCounter>();
        PacedFrames.Begin(new PaceLink(socket), [.. counters]);
        if (Variable(MethodVariable) is not { } name) return;
        MethodInfo method = Find(name, (type, member) => type.GetMethod(member, Static, Type.EmptyTypes))
            ?? throw new InvalidOperationException($"No script assembly has the method '{name}'.");
        method.Invoke(null, BindingFlags.DoNotWrapExceptions, null, null, null);
    }

    private static string? Variable(string name) => Environment.GetEnvironmentVariable(name) is { Length: > 0 } value ? value : null;

    // A build that has no such property is played without the figure.
    private static FrameCounter? Counter(string name) =>
        Find(name, (type, member) => type.GetProperty(member, Static)) is { } property ? new FrameCounter(name, () => Convert.ToInt64(property.GetValue(null))) : null;

    private static T? Find<T>(string name, Func<Type, string, T?> member) where T : class
    {
        int dot = name.LastIndexOf('.');
        return AppDomain.CurrentDomain.GetAssemblies().Select(a => a.GetType(name[..dot])).OfType<Type>()
            .Select(type => member(type, name[(dot + 1)..])).FirstOrDefault(found => found is not null);
    }
}
