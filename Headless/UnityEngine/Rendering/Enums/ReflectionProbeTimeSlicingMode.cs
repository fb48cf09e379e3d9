namespace UnityEngine.Rendering;

public enum ReflectionProbeTimeSlicingMode
{
    AllFacesAtOnce = 0,
    IndividualFaces = 1,
    NoTimeSlicing = 2,
}
