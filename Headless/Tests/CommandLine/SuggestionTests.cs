using Headless.CommandLine;
using NUnit.Framework;

namespace Headless.Tests.CommandLine;

public sealed class SuggestionTests
{
    private static readonly string[] flags = ["--scene", "--seconds", "--fps", "--size", "--surface", "--seed"];

    [TestCase("--szie", "--size", TestName = "TwoLettersSwapped")]
    [TestCase("--sizes", "--size", TestName = "OneTooMany")]
    [TestCase("--scen", "--scene", TestName = "OneMissing")]
    [TestCase("--surfaec", "--surface", TestName = "TwoSwappedInALongWord")]
    [TestCase("--sorfacce", "--surface", TestName = "TwoLettersWrongInALongWord")]
    [TestCase("--fsp", "--fps", TestName = "InAShortWord")]
    [TestCase("--speed", "--seed", TestName = "ALetterTooMany")]
    public void TheNearestIsAskedFor(string word, string nearest) => Assert.That(Suggestion.Question(word, flags), Is.EqualTo($"; did you mean {nearest}?"));

    [TestCase("--colour")]
    [TestCase("--xyz")]
    [TestCase("")]
    [TestCase("-")]
    public void NothingIsNearWhereMoreThanAThirdDiffers(string word) => Assert.That(Suggestion.Question(word, flags), Is.EqualTo("."));

    [TestCase("acb", "abc", 1)]
    [TestCase("ca", "abc", 0)]
    [TestCase("abc", "", 0)]
    public void NoPieceIsChangedTwice(string word, string known, int found) => Assert.That(Suggestion.Nearest(word, [known]) is null ? 0 : 1, Is.EqualTo(found));
}
