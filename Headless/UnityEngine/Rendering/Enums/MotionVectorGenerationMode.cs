namespace UnityEngine;

public enum MotionVectorGenerationMode
{
    Camera = 0,
    Object = 1,
    ForceNoMotion = 2,
}
