namespace UnityEngine.Events;

/// <summary>When a listener set in an inspector is called.</summary>
public enum UnityEventCallState
{
    Off = 0,
    EditorAndRuntime = 1,
    RuntimeOnly = 2,
}

/// <summary>The argument that a listener set in an inspector is called with.</summary>
public enum PersistentListenerMode
{
    EventDefined = 0,
    Void = 1,
    Object = 2,
    Int = 3,
    Float = 4,
    String = 5,
    Bool = 6,
}
