namespace UnityEngine;

public enum ForceMode
{
    Force = 0,
    Impulse = 1,
    VelocityChange = 2,
    Acceleration = 5,
}
