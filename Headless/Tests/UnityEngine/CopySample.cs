using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class CopySample : MonoBehaviour
{
    public Transform? target;
    public float[] values = Array.Empty<float>();
    public Inner nested = new();
    [SerializeField] int m_Hidden;
    [NonSerialized] public int notSaved;

    public int Hidden => m_Hidden;
    public void SetHidden(int value) => m_Hidden = value;

    [Serializable]
    public class Inner
    {
        public List<Vector3> points = new();
        public string label = "";
    }
}
