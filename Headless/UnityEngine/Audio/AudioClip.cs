using Headless.Engine;

namespace UnityEngine;

/// <summary>Samples in memory; the player has no sound.</summary>
public sealed class AudioClip : Object
{
    float[] m_Samples = [];

    private AudioClip() { }

    public int samples { get; private set; }
    public int channels { get; private set; }
    public int frequency { get; private set; }
    public float length => samples / (float)frequency;

    public static AudioClip Create(string name, int lengthSamples, int channels, int frequency, bool stream)
    {
        if (lengthSamples <= 0) throw new ArgumentException("Length of created clip must be larger than 0");
        return new AudioClip { name = name, samples = lengthSamples, channels = channels, frequency = frequency, m_Samples = new float[lengthSamples * channels] };
    }

    public bool SetData(float[] data, int offsetSamples)
    {
        data.AsSpan(0, Math.Min(data.Length, m_Samples.Length - offsetSamples * channels)).CopyTo(m_Samples.AsSpan(offsetSamples * channels));
        return true;
    }

    public bool GetData(float[] data, int offsetSamples)
    {
        m_Samples.AsSpan(offsetSamples * channels, Math.Min(data.Length, m_Samples.Length - offsetSamples * channels)).CopyTo(data);
        return true;
    }
}
