using NUnit.Framework;

namespace Headless.Tests.CommandLine;

public sealed class ArgumentsTests
{
    private static readonly Flag[] flags =
    [
        new("--size", "WxH", "size"), new("--mode", "NAME", "mode") { Choices = ["edit", "play"] }, new("--count", "N", "count"), Flag.Switch("--quick", "short"),
    ];

    [TestCase("--szie is not a flag of it; did you mean --size? Its flags are --count, --mode, --quick, --size.", "--szie", "1x1")]
    [TestCase("--siz is not a flag of it; did you mean --size? Its flags are --count, --mode, --quick, --size.", "--siz=1x1")]
    [TestCase("--something is not a flag of it. Its flags are --count, --mode, --quick, --size.", "--something")]
    [TestCase("--mode must be one of edit, play, found 'paly'; did you mean play?", "--mode", "paly")]
    [TestCase("--mode must be one of edit, play, found 'all'.", "--mode=all")]
    public void TheNearestIsNamed(string message, params string[] words) =>
        Assert.That(() => new Arguments("it", words, flags), Throws.TypeOf<UsageException>().With.Message.EqualTo(message));

    [TestCase("7", 7)]
    [TestCase("0", 0)]
    public void AWholeNumberIsRead(string text, int expected) =>
        Assert.That(new Arguments("it", ["--count", text], flags).Whole("--count", 3), Is.EqualTo(expected));

    [TestCase("1.5")]
    [TestCase("many")]
    public void AnotherIsRefused(string text) => Assert.That(
        () => new Arguments("it", ["--count", text], flags).Whole("--count", 3),
        Throws.TypeOf<UsageException>().With.Message.EqualTo($"--count must be a whole number, found '{text}'."));

    [Test]
    public void WithoutFlagsTheAbsentHolds()
    {
        var arguments = new Arguments("it", [], flags);
        Assert.That((arguments.Whole("--count", 3), arguments.Text("--mode", "edit"), arguments.Has("--quick")), Is.EqualTo((3, "edit", false)));
    }
}
