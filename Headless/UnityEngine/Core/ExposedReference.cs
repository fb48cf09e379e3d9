using System;

namespace UnityEngine;

[Serializable]
public struct ExposedReference<T> where T : Object
{
    [SerializeField] public PropertyName exposedName;
    [SerializeField] public Object defaultValue;

    public T Resolve(IExposedPropertyTable resolver)
    {
        if (resolver is null) return (defaultValue as T)!;
        Object found = resolver.GetReferenceValue(exposedName, out bool isValid);
        return ((isValid ? found : defaultValue) as T)!;
    }
}
