using System;

namespace UnityEngine.Rendering;

public class ProfilingSampler
{
    public ProfilingSampler(string name) => this.name = name;

    public string name { get; }

    public static ProfilingSampler Get<TEnum>(TEnum marker)
        where TEnum : Enum => new(marker.ToString());

    public void Begin(CommandBuffer? cmd) => cmd?.BeginSample(name);

    public void End(CommandBuffer? cmd) => cmd?.EndSample(name);
}
