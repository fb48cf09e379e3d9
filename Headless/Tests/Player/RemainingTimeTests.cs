using Headless.Player.Output;
using NUnit.Framework;

namespace Headless.Tests.Player;

/// <summary>Estimates of a play from the times at which frames were finished; none may be off by more than a factor of two.</summary>
public sealed class RemainingTimeTests
{
    private static RemainingTime After(int frames, params double[] arrivals)
    {
        var remaining = new RemainingTime(frames);
        for (int i = 0; i < arrivals.Length; i++) remaining.Add(i + 1, arrivals[i]);
        return remaining;
    }

    [TestCase(TestName = "NothingIsSaidOfNoFrame")]
    [TestCase(5.0, TestName = "NothingIsSaidOfFrame0Alone")]
    [TestCase(5.0, 5.1, 5.2, TestName = "NothingIsSaidOfTheFramesThatFillTheRing")]
    public void NothingIsSaid(params double[] arrivals)
    {
        RemainingTime remaining = After(100, arrivals);
        Assert.That((remaining.SecondsPerFrame, remaining.Left(6)), Is.EqualTo(((double?)null, (TimeSpan?)null)));
    }

    [Test]
    public void FramesThatTakeLongAreSpokenOfAtOnce() =>
        Assert.That(After(11, 5, 15).Left(15)!.Value.TotalSeconds, Is.EqualTo(90).Within(1e-9));

    [Test]
    public void Frame0IsNoMeasureOfTheOthers()
    {
        // Frame 0 compiles for twenty seconds; the others take one each.
        RemainingTime remaining = After(11, 20, 21, 22, 23, 24);
        Assert.That(remaining.SecondsPerFrame, Is.EqualTo(1).Within(1e-9));
        Assert.That(remaining.Left(24)!.Value.TotalSeconds, Is.EqualTo(6).Within(1e-9));
        Assert.That(remaining.Left(24.5)!.Value.TotalSeconds, Is.EqualTo(5.5).Within(1e-9), "time goes on between frames");
        Assert.That(remaining.Left(99)!.Value.TotalSeconds, Is.Zero);
    }

    [TestCase(2)]
    [TestCase(3)]
    [TestCase(4)]
    public void FramesThatComeInBurstsAreAveraged(int burst)
    {
        // As many as the ring holds arrive at once, then nothing for as long.
        var remaining = new RemainingTime(101);
        remaining.Add(1, 5);
        for (int frame = 2; frame <= 101; frame++)
        {
            double seconds = 5 + 0.5 * burst * Math.Ceiling((frame - 1) / (double)burst);
            remaining.Add(frame, seconds);
            double actual = 5 + 0.5 * burst * Math.Ceiling(100 / (double)burst) - seconds;
            if (frame >= 11 && actual > 4) Assert.That(remaining.Left(seconds)!.Value.TotalSeconds / actual, Is.InRange(0.5, 2), $"frame {frame}");
        }
    }

    [Test]
    public void ASplashThatCostsMoreThanTheFallIsLearnt()
    {
        // A second a frame at first, two from the fortieth on.
        var remaining = new RemainingTime(100);
        double seconds = 5;
        for (int frame = 1; frame <= 80; frame++) remaining.Add(frame, seconds += frame < 40 ? 1 : 2);
        Assert.That(remaining.Left(seconds)!.Value.TotalSeconds, Is.EqualTo(40).Within(1e-9));
    }

    [TestCase(1, "about 5 s")]
    [TestCase(42, "about 40 s")]
    [TestCase(100, "about 2 min")]
    [TestCase(60 * 90, "about 1 h 30 min")]
    [TestCase(3600 * 3, "about 3 h")]
    public void TimesAreSaidAsPeopleDo(double seconds, string said) =>
        Assert.That(RemainingTime.About(TimeSpan.FromSeconds(seconds)), Is.EqualTo(said));

    [Test]
    public void TheWholeIsSaidOnce()
    {
        var output = new StringWriter();
        using var activity = new ActivityLine(output, terminal: false);
        var progress = new ProgressLine(activity, frames: 100, " of 960x540");
        for (int frame = 0; frame < 20; frame++)
        {
            progress.Finished(frame + 1, 5 + frame);
            progress.Show(frame / 24.0, 5 + frame);
        }
        string[] lines = [.. output.ToString().Split('\n').Where(l => l.StartsWith("about", StringComparison.Ordinal))];
        Assert.That(lines, Is.EqualTo(new[] { "about 2 min for 100 frames of 960x540; about 2 min left" }));
    }
}
