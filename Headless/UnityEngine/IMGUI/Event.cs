namespace UnityEngine;

public sealed class Event
{
    public Event() { }

    public Event(Event other)
    {
        type = other.type;
        mousePosition = other.mousePosition;
        delta = other.delta;
        button = other.button;
    }

    /// <summary>Null outside GUI code, as in Unity.</summary>
    public static Event current { get; set; } = null!;

    public EventType type { get; set; } = EventType.Ignore;
    public EventType rawType => type;
    public Vector2 mousePosition { get; set; }
    public Vector2 delta { get; set; }
    public int button { get; set; }
    public bool shift { get; set; }
    public bool control { get; set; }
    public bool alt { get; set; }

    public void Use() => type = EventType.Used;
}
