namespace UnityEngine.Rendering;

public enum OpaqueSortMode
{
    Default = 0,
    FrontToBack = 1,
    NoDistanceSort = 2,
}
