namespace UnityEngine;

/// <summary>Keeps what it is given and knows whether it plays; nothing is heard.</summary>
public sealed class AudioSource : AudioBehaviour
{
    float m_Volume = 1f;

    public AudioClip clip { get; set; } = null!;
    public bool loop { get; set; }
    public float spatialBlend { get; set; }
    public float pitch { get; set; } = 1f;
    public float volume { get => m_Volume; set => m_Volume = Mathf.Clamp01(value); }
    public bool isPlaying { get; private set; }

    public void Play() => isPlaying = clip != null && isActiveAndEnabled;
    public void Stop() => isPlaying = false;
}
