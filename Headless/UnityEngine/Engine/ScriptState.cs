using System;

namespace Headless.Engine;

/// <summary>What the player loop remembers about one script instance.</summary>
sealed class ScriptState
{
    public ScriptType? Type;
    public bool AwakeCalled;
    public bool EnableCalled;
    public bool StartCalled;
    public long Sequence;
    public Action? FixedUpdate;
    public Action? Update;
    public Action? LateUpdate;
}
