namespace Headless.Measure.Children;

/// <summary>How a child process ended, from good to bad.</summary>
internal enum ChildEnding
{
    Done,

    /// <summary>It was not begun, as too little time was left.</summary>
    LeftOut,

    /// <summary>It took longer than its limit and was ended.</summary>
    Stopped,

    /// <summary>It said what went wrong and ended by itself.</summary>
    Failed,
    OutOfMemory,
    Crashed,

    /// <summary>Even killing did not end it, as when it hangs in a driver; it may still run.</summary>
    LeftBehind,
}
