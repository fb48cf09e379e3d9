namespace UnityEngine.Playables;

public enum PlayState
{
    Paused,
    Playing,
}
