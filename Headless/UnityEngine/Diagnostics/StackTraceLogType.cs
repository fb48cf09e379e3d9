namespace UnityEngine;

public enum StackTraceLogType
{
    None = 0,
    ScriptOnly = 1,
    Full = 2,
}
