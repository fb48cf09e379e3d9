namespace UnityEngine.Rendering;

public enum ReflectionProbeSortingCriteria
{
    None = 0,
    Importance = 1,
    Size = 2,
    ImportanceThenSize = 3,
}
