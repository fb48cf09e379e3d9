using Headless.Bench.Model;
using NUnit.Framework;

namespace Headless.Tests.Bench;

/// <summary>Turns of waves against counts by hand and against all pairs.</summary>
public sealed class WaveStatisticsTests
{
    [Test]
    public void TwoParticlesInACellTakeTwoTurns()
    {
        WaveStatistics waves = WaveStatistics.Of([(0, 0, 0), (0.5f, 0, 0)], 1f, 32);

        Assert.That(waves, Is.EqualTo(new WaveStatistics(32, 2, 1, 2, 1, 1)));
    }

    [Test]
    public void AWaveGoesWithItsLongestLane()
    {
        // A lone particle, and three that see each other: the lone one waits for them.
        (float, float, float)[] positions = [(0, 0, 0), (10, 10, 10), (10.1f, 10, 10), (10.2f, 10, 10)];

        Assert.That(WaveStatistics.Of(positions, 1f, 4).NeighbourTurns, Is.EqualTo(2));
        Assert.That(WaveStatistics.Of(positions, 1f, 1).NeighbourTurns, Is.EqualTo(1.5));
    }

    [TestCase(1)]
    [TestCase(63)]
    [TestCase(1009)]
    public void NeighboursAreThoseOfAllPairs(int count)
    {
        const float radius = 0.3f;
        var random = new Random(count);
        var positions = Enumerable.Range(0, count).Select(_ => (X: random.NextSingle(), Y: random.NextSingle(), Z: random.NextSingle())).ToArray();
        long pairs = 0;
        for (int i = 0; i < count; i++)
            for (int j = 0; j < count; j++)
            {
                float x = positions[j].X - positions[i].X, y = positions[j].Y - positions[i].Y, z = positions[j].Z - positions[i].Z;
                pairs += i != j && x * x + y * y + z * z < radius * radius ? 1 : 0;
            }

        WaveStatistics waves = WaveStatistics.Of(positions, radius, 64);

        Assert.That(waves.Neighbours, Is.EqualTo((double)pairs / count).Within(1e-9));
        Assert.That(waves.Candidates, Is.GreaterThanOrEqualTo(waves.Neighbours + 1));
        Assert.That(waves.CandidateTurns, Is.GreaterThanOrEqualTo(waves.Candidates - 1e-9));
    }
}
