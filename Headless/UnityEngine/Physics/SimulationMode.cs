namespace UnityEngine;

public enum SimulationMode
{
    FixedUpdate = 0,
    Update = 1,
    Script = 2,
}
