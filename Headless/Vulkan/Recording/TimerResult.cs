namespace Headless.Vulkan;

/// <summary>A finished timer scope.</summary>
/// <param name="Id">What <see cref="CommandRecorder.BeginTimer"/> returned.</param>
/// <param name="Name">Its name.</param>
/// <param name="Milliseconds">GPU time of what was recorded between begin and end.</param>
/// <param name="Depth">Nesting depth; 0 is outermost.</param>
public readonly record struct TimerResult(int Id, string Name, double Milliseconds, int Depth);
