namespace UnityEngine.Playables;

public enum DirectorUpdateMode
{
    DSPClock,
    GameTime,
    UnscaledGameTime,
    Manual,
}
