using System.Collections.Concurrent;
using System.Text.RegularExpressions;

namespace Headless.Shaders.Direct3D;

/// <summary>Compiles stages with FXC; as many processes as threads ask at the same time. Safe for several threads.</summary>
internal sealed partial class FxcCompiler(WineToolchain toolchain) : IDisposable
{
    private const string Profile = "cs_5_0";

    private readonly ConcurrentBag<FxcSession> _idle = [];
    private readonly Lazy<string?> _problem = new(toolchain.Prepare);

    /// <summary>What is missing on this machine and how to get it; null when all is there.</summary>
    public string? Problem => _problem.Value;

    /// <summary>The compiled kernel as a DXBC container.</summary>
    /// <exception cref="ShaderCompileException">An error in the source, or no compiler.</exception>
    public byte[] Compile(StageJob job)
    {
        if (Problem is { } problem)
        {
            throw new ShaderCompileException(job.Source.Files[0], 0, $"{problem} ({job.Owner})");
        }
        string text = FxcText.From(job.Text, job.Source);
        if (toolchain.KnownCode(text, job.SourceEntryPoint, Profile) is { } known)
        {
            return known;
        }
        // A process that another one's fault has ended is replaced once; a source that crashes the next one too is at fault itself.
        (byte[]? code, string messages, bool crashed) = Ask(job, text);
        if (crashed)
        {
            (code, messages, _) = Ask(job, text);
        }
        return code ?? throw Failure(job, messages);
    }

    private (byte[]? Code, string Messages, bool Crashed) Ask(StageJob job, string text)
    {
        FxcSession session = _idle.TryTake(out FxcSession? found) ? found : new FxcSession(toolchain);
        try
        {
            (byte[]? code, string messages) = session.Compile(text, job.SourceEntryPoint, Profile);
            return (code, messages, !session.Alive);
        }
        finally
        {
            if (session.Alive)
            {
                _idle.Add(session);
            }
            else
            {
                session.Dispose();
            }
        }
    }

    public void Dispose()
    {
        while (_idle.TryTake(out FxcSession? session))
        {
            session.Dispose();
        }
    }

    // "/folder/File.hlsl(12,5-9): error X3004: undeclared identifier 'x'"
    private static ShaderCompileException Failure(StageJob job, string messages)
    {
        string first = messages.Split(" | ").FirstOrDefault(m => m.Contains("error", StringComparison.Ordinal)) ?? messages;
        Match place = ErrorPlace().Match(first);
        return place.Success
            ? new ShaderCompileException(place.Groups[1].Value, int.Parse(place.Groups[2].Value), $"{place.Groups[3].Value} at {job.Owner}")
            : new ShaderCompileException(job.Source.Files[0], 0, $"{first} at {job.Owner}");
    }

    [GeneratedRegex(@"^(?:[A-Z]:)?(.*?)\((\d+),[^)]*\): error X\d+: (.*)$")]
    private static partial Regex ErrorPlace();
}
