namespace Headless.Player;

/// <summary>Who speaks in front of a message: the verb as <c>./run</c> was given it, else the player.</summary>
internal static class Message
{
    /// <summary>Set by <c>./run</c>.</summary>
    public const string Variable = "SPHPLAYER_VERB";

    private static string Speaker => Environment.GetEnvironmentVariable(Variable) is { Length: > 0 } verb ? verb : "sphplayer";

    public static string Of(string text) => $"{Speaker}: {text}";
}
