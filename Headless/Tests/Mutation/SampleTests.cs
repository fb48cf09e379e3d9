using Headless.Mutation;
using Headless.Mutation.Hlsl;
using NUnit.Framework;

namespace Headless.Tests.Mutation;

public class SampleTests
{
    private static IReadOnlyList<Mutant> File(string name, int lines) =>
        HlslMutator.Find(name, "void F()\n{\n" + string.Concat(Enumerable.Range(0, lines).Select(i => $"    float s{i} = a + b{i};\n")) + "}\n");

    private static List<Mutant> Draw(int seed, params IReadOnlyList<Mutant>[] files)
    {
        var sample = new Sample(files, seed);
        List<Mutant> drawn = [];
        while (drawn.Count < 12 && sample.Next() is { } mutant) drawn.Add(mutant);
        return drawn;
    }

    [Test]
    public void ASeedIsOneSample()
    {
        string[] Keys(int seed) => [.. Draw(seed, File("a", 9), File("b", 30)).Select(m => m.Key)];
        Assert.That(Keys(1), Is.EqualTo(Keys(1)));
        Assert.That(Keys(1), Is.Not.EqualTo(Keys(2)));
    }

    [Test]
    public void EveryFileHasItsShare()
    {
        List<Mutant> drawn = Draw(1, File("a", 9), File("b", 36), File("c", 1));
        Assert.That(drawn.Select(m => m.Key).Distinct().Count(), Is.EqualTo(12));
        Assert.That(drawn.Count(m => m.File == "c"), Is.GreaterThanOrEqualTo(1));
        Assert.That(drawn.Count(m => m.File == "b"), Is.GreaterThan(drawn.Count(m => m.File == "a")));
    }

    [Test]
    public void AnEditedFileLeavesTheOthersSample()
    {
        string[] OfA(int linesOfB) => [.. Draw(1, File("a", 9), File("b", linesOfB)).Where(m => m.File == "a").Select(m => m.Key)];
        string[] few = OfA(30), many = OfA(31);
        int shared = Math.Min(few.Length, many.Length);
        Assert.That(few.Take(shared), Is.EqualTo(many.Take(shared)));
    }
}
