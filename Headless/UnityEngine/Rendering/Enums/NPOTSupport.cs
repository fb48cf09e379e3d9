namespace UnityEngine;

public enum NPOTSupport
{
    None = 0,
    Restricted = 1,
    Full = 2,
}
