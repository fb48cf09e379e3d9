namespace UnityEngine;

public enum LogOption
{
    None = 0,
    NoStacktrace = 1,
}
