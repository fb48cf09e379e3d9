using Headless.Player;
using Headless.Player.Commands;
using NUnit.Framework;

namespace Headless.Tests.Player;

public sealed class PlayOptionsTests
{
    private static readonly string[] Needed = ["--project", ".", "--scene", "a.unity"];

    private static PlayOptions Parse(params string[] words) => PlayOptions.Parse([.. Needed, .. words]);

    [Test]
    public void DefaultsAreThoseOfTheContract()
    {
        PlayOptions options = Parse();
        Assert.That((options.Seconds, options.Fps, options.Width, options.Height, options.Frames, options.Images), Is.EqualTo((1.5, 24d, 960, 540, 37, true)));
    }

    [Test]
    public void FlagsAreRead()
    {
        PlayOptions options = Parse("--seconds", "0.5", "--fps=60", "--size", "64x48", "--no-images", "--validate", "--device", "llvmpipe", "--pipeline", "built-in", "--stereo", "instanced");
        Assert.That((options.Frames, options.Width, options.Height, options.Images, options.Validate, options.Device), Is.EqualTo((31, 64, 48, false, true, "llvmpipe")));
        Assert.That((options.Pipeline, options.Stereo), Is.EqualTo(("built-in", "instanced")));
    }

    [Test]
    public void WhatFollowsTheDashesIsLeftToTheProject() =>
        Assert.That(Parse("--fps", "10", "--", "--method", "thesis", "--fps").Fps, Is.EqualTo(10));

    [TestCase("--seconds must be a number of seconds from 0.001 to 86400, found '-1'.", "--seconds", "-1")]
    [TestCase("--fps must be a number of frames a second from 0.01 to 1000, found 'fast'.", "--fps", "fast")]
    [TestCase("--size must be WxH in pixels, each 1 to 16384 and 33177600 in all, as 1280x720; found '1280'.", "--size", "1280")]
    [TestCase("--size must be WxH in pixels, each 1 to 16384 and 33177600 in all, as 1280x720; found '0x720'.", "--size", "0x720")]
    [TestCase("--fps must be a number of frames a second from 0.01 to 1000, found '1e-30'.", "--fps", "1e-30")]
    [TestCase("--fps must be a number of frames a second from 0.01 to 1000, found 'NaN'.", "--fps", "NaN")]
    [TestCase("--seconds must be a number of seconds from 0.001 to 86400, found '1e400'.", "--seconds", "1e400")]
    [TestCase("--seconds 86400 at --fps 1000 are more than 1000000 frames; play less time or fewer frames a second.", "--seconds", "86400", "--fps", "1000")]
    [TestCase("--size must be WxH in pixels, each 1 to 16384 and 33177600 in all, as 1280x720; found '16384x16384'.", "--size", "16384x16384")]
    [TestCase("--out must not be empty.", "--out", "")]
    [TestCase("--out must not be empty.", "--out=")]
    [TestCase("--device must not be empty.", "--device", " ")]
    [TestCase("--pipeline must be one of universal, built-in, found 'univesal'; did you mean universal?", "--pipeline", "univesal")]
    [TestCase("--seconds needs a value.", "--seconds")]
    [TestCase("--seconds needs a value.", "--seconds", "--fps", "3")]
    [TestCase("--fps is given twice.", "--fps", "3", "--fps", "4")]
    [TestCase("--no-images takes no value, found 'yes'.", "--no-images=yes")]
    [TestCase("'stray' is not understood by play: flags begin with --.", "stray")]
    public void WrongValuesAreNamed(string message, params string[] words) =>
        Assert.That(() => Parse(words), Throws.TypeOf<UsageException>().With.Message.EqualTo(message));

    [Test]
    public void UnknownFlagsAreNamedWithThoseThatExist() =>
        Assert.That(() => Parse("--speed", "3"), Throws.TypeOf<UsageException>().With.Message.StartsWith("--speed is not a flag of play. Its flags are --assemblies, --device"));

    [Test]
    public void PicturesThatAreNotMadeCannotBeCompared() =>
        Assert.That(() => Parse("--no-images", "--twice"), Throws.TypeOf<UsageException>().With.Message.StartsWith("--twice compares pictures, and --no-images makes none"));

    [Test]
    public void AFilmThatIsNotMadeCannotBeShown() =>
        Assert.That(() => Parse("--no-images", "--open"), Throws.TypeOf<UsageException>().With.Message.StartsWith("--open shows a film, and --no-images makes none"));

    [Test]
    public void TheSceneIsNeededAndMustBeOne()
    {
        Assert.That(() => PlayOptions.Parse(["--project", "."]), Throws.TypeOf<UsageException>().With.Message.EqualTo("--scene is missing."));
        Assert.That(() => PlayOptions.Parse(["--project", ".", "--scene", "a.txt"]), Throws.TypeOf<UsageException>().With.Message.EqualTo("--scene must be a .unity file, found 'a.txt'."));
        Assert.That(() => PlayOptions.Parse(["--project", "/nowhere", "--scene", "a.unity"]), Throws.TypeOf<UsageException>().With.Message.EqualTo("--project: the folder '/nowhere' does not exist."));
    }
}
