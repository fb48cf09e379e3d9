namespace UnityEngine;

public enum DeviceType
{
    Unknown = 0,
    Handheld = 1,
    Console = 2,
    Desktop = 3,
}
