using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Pacing;

/// <summary>Holds each frame until it may begin, with the device idle, and reports what the frames before it did.</summary>
[DefaultExecutionOrder(-32000)]
internal sealed class PacedFrames : MonoBehaviour
{
    private readonly List<Camera> switchedOff = [];
    private PaceLink link = null!;
    private FrameCounter[] counters = [];
    private FinishedScopes scopes = null!;
    private GraphicsBuffer idle = null!;
    private int frame, free;

    public static void Begin(PaceLink link, FrameCounter[] counters)
    {
        var holder = new GameObject("Pacer") { hideFlags = HideFlags.HideAndDontSave };
        DontDestroyOnLoad(holder);
        var frames = holder.AddComponent<PacedFrames>();
        (frames.link, frames.counters) = (link, counters);
        frames.scopes = new FinishedScopes(link.Gpu);
        frames.idle = new GraphicsBuffer(GraphicsBuffer.Target.Structured, 1, sizeof(int));
    }

    private void Update()
    {
        foreach (FrameCounter counter in counters)
        {
            long grown = counter.Advance();
            if (frame > 0) link.Count(frame - 1, grown, counter.Name);
        }
        if (free > 0) free--;
        else Hold();
        frame++;
    }

    private void Hold()
    {
        // Reading waits for all that was submitted: nothing of this player works while another one is measured.
        idle.GetData(new int[1]);
        if (link.Ask(frame, Time.timeAsDouble) is not { } answer)
        {
            Application.Quit(1);
            return;
        }
        free = answer.Frames - 1;
        if (answer.Draws) SwitchOn();
        else SwitchOff();
    }

    private void SwitchOff()
    {
        foreach (Camera camera in FindObjectsByType<Camera>(FindObjectsSortMode.None))
        {
            if (!camera.enabled) continue;
            camera.enabled = false;
            switchedOff.Add(camera);
        }
    }

    private void SwitchOn()
    {
        foreach (Camera camera in switchedOff)
            if (camera != null) camera.enabled = true;
        switchedOff.Clear();
    }

    private void OnDestroy()
    {
        scopes.Dispose();
        idle.Dispose();
        link.Dispose();
    }
}
