using SphFluid.Validation;

namespace Headless.CommandLine;

/// <summary>What somebody may have meant who mistyped a word.</summary>
public static class Suggestion
{
    /// <summary>The end of a sentence: "; did you mean --size?", or a full stop where nothing is near.</summary>
    public static string Question(string word, IEnumerable<string> known) => NearestWord.Question(word, known);
}
