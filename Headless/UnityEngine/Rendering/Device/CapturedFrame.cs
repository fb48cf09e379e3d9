namespace Headless.Engine;

/// <param name="Pixels">RGBA bytes in sRGB, top row first.</param>
internal readonly record struct CapturedFrame(int Frame, int Width, int Height, byte[] Pixels);
