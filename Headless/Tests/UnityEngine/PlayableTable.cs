using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

public sealed class PlayableTable : MonoBehaviour, IExposedPropertyTable
{
    readonly Dictionary<PropertyName, Object> m_Values = new();

    public void SetReferenceValue(PropertyName id, Object value) => m_Values[id] = value;

    public Object GetReferenceValue(PropertyName id, out bool idValid)
    {
        idValid = m_Values.TryGetValue(id, out Object? value);
        return value!;
    }

    public void ClearReferenceValue(PropertyName id) => m_Values.Remove(id);
}
