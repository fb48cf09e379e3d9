using System.Collections.Generic;
using System.Linq;
using Headless.Vulkan;

namespace Headless.Engine;

/// <summary>Hands out finished frames some frames late, so that neither side waits for the other.</summary>
internal sealed class ScreenReadback(int depth = 3)
{
    private readonly Queue<(int Frame, int Width, int Height, ReadbackTicket Ticket, GuiPicture Gui)> pending = new();

    public int Pending => pending.Count;

    /// <summary>Asks for the screen as it is now.</summary>
    public void Capture(int frame) => pending.Enqueue((frame, ScreenTarget.Width, ScreenTarget.Height, ScreenTarget.RequestPixels(), GuiPicture.OfFrame()));

    /// <summary>Takes the oldest frame if it has arrived, or waits for it when too many have not arrived or finish is set.</summary>
    public bool TryTake(bool finish, out CapturedFrame frame)
    {
        frame = default;
        if (pending.Count == 0 || (!finish && pending.Count <= depth && !pending.Peek().Ticket.IsDone))
        {
            return false;
        }

        (int number, int width, int height, ReadbackTicket ticket, GuiPicture gui) = pending.Dequeue();
        byte[] pixels = ticket.Wait().ToArray();
        gui.Paint(pixels, width, height);
        frame = new CapturedFrame(number, width, height, pixels);
        return true;
    }
}
