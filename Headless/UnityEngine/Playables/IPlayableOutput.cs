namespace UnityEngine.Playables;

public interface IPlayableOutput
{
    PlayableOutputHandle GetHandle();
}
