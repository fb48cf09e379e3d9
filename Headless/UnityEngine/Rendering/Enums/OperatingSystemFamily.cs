namespace UnityEngine;

public enum OperatingSystemFamily
{
    Other = 0,
    MacOSX = 1,
    Windows = 2,
    Linux = 3,
}
