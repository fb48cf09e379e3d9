using System.Text;

namespace Headless.Help;

/// <summary>The flags as bash reads them: <c>run</c> refuses unknown ones before anything is built, and parts the player's from the package's.</summary>
internal static class ShellTable
{
    public static string Of(IReadOnlyList<Verb> verbs)
    {
        var text = new StringBuilder("# Written by ./run help --update from the flags that the parsers read; run reads it.\n");
        text.Append($"verbs='{Names(verbs.Select(v => v.Name))}'\n");
        Verb play = verbs.Single(v => v.Name == "play");
        foreach (string flag in new[] { "liquid", "method" }) text.Append($"{flag}s='{Names(play.Own.Single(f => f.Name == "--" + flag).Choices)}'\n");
        Table(text, "all_flags", verbs, v => v.AllFlags);
        Table(text, "player_values", verbs, v => v.OfPlayer.Where(f => f.Value is not null && !f.Hidden));
        Table(text, "player_switches", verbs, v => v.OfPlayer.Where(f => f.Value is null && !f.Hidden));
        return text.ToString();
    }

    private static void Table(StringBuilder text, string name, IReadOnlyList<Verb> verbs, Func<Verb, IEnumerable<Flag>> flags)
    {
        text.Append($"declare -A {name}=(\n");
        foreach (Verb verb in verbs.Where(v => flags(v).Any())) text.Append($"    [{verb.Name}]='{Names(flags(verb).Select(f => f.Name))}'\n");
        text.Append(")\n");
    }

    private static string Names(IEnumerable<string> names) => string.Join(' ', names);
}
