namespace Headless.Engine;

/// <summary>What a coroutine waits for.</summary>
enum WaitKind
{
    NextFrame,
    FixedUpdate,
    EndOfFrame,
    Nested,
}
