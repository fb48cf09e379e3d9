using Headless.Engine;

namespace UnityEngine;

public sealed class Screen
{
    public static int width => ScreenTarget.Width;
    public static int height => ScreenTarget.Height;
    public static float dpi => 96f;
    public static bool fullScreen { get; set; }
    public static FullScreenMode fullScreenMode { get; set; } = FullScreenMode.Windowed;
    public static Rect safeArea => new(0f, 0f, width, height);
    public static int sleepTimeout { get; set; }

    public static Resolution currentResolution => new() { width = width, height = height };

    public static Resolution[] resolutions => [currentResolution];

    public static void SetResolution(int width, int height, bool fullscreen) => ScreenTarget.Resize(width, height);

    public static void SetResolution(int width, int height, FullScreenMode fullscreenMode) => ScreenTarget.Resize(width, height);
}
