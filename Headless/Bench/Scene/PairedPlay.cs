using System.Diagnostics;

namespace Headless.Bench.Scene;

/// <summary>Plays one build, or two in turns: in measured frames only one of them works at a time, and who goes first changes from frame to frame.</summary>
internal sealed class PairedPlay(SceneOptions options, IReadOnlyList<PacedPlayer> players, int frames)
{
    // Frames before a span that are played as in it, so that what cameras bring is there.
    private const int Lead = 3;

    /// <summary>Number of frames that hold all spans. GPU times of a frame come one or two frames later.</summary>
    public static int Frames(SceneOptions options) => (int)Math.Ceiling(options.Phases[^1].To * options.Fps) + Lead + 1;

    /// <param name="progress">Called now and then with the frame.</param>
    public void Run(Action<int> progress)
    {
        var since = Stopwatch.StartNew();
        foreach (PacedPlayer player in players) player.WaitFor(0);
        for (int frame = 0; frame < frames;)
        {
            int blind = BlindFrom(frame);
            if (blind > 0)
            {
                foreach (PacedPlayer player in players) player.Go(blind, draws: false);
                frame += blind;
                foreach (PacedPlayer player in players) player.WaitFor(frame);
            }
            else
            {
                for (int i = 0; i < players.Count; i++)
                    players[(i + frame) % players.Count].Play(frame, last: frame + 1 == frames);
                frame++;
            }
            if (since.Elapsed.TotalSeconds < 10) continue;
            progress(frame);
            since.Restart();
        }
        foreach (PacedPlayer player in players) player.Finish();
    }

    // Frames from here on that no span needs.
    private int BlindFrom(int frame)
    {
        int count = 0;
        while (frame + count < frames - Lead && !IsNearSpan(frame + count)) count++;
        return count;
    }

    private bool IsNearSpan(int frame) =>
        frame <= 1 || Enumerable.Range(frame, Lead + 1).Any(f => options.Phases.Any(p => p.Has(f, options.Fps)));
}
