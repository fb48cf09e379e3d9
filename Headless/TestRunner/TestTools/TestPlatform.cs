namespace UnityEngine.TestTools;

[Flags]
public enum TestPlatform : byte
{
    All = 0xFF,
    EditMode = 1 << 1,
    PlayMode = 1 << 2,
}
