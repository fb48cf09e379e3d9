using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class JsonUtilityTests
{
    [Serializable]
    public class Sample
    {
        public int count = 3;
        public float size = 1.5f;
        public string label = "a \"b\"";
        public Vector3 point = new(1f, 2f, 3f);
        public List<int> list = new() { 1, 2 };
        public LogType kind = LogType.Warning;
        [SerializeField] bool m_Flag = true;
        [NonSerialized] public int skipped = 5;

        public bool Flag => m_Flag;
    }

    [Test]
    public void WritesFieldsByName() => Assert.That(JsonUtility.ToJson(new Sample()), Is.EqualTo(
        "{\"count\":3,\"size\":1.5,\"label\":\"a \\\"b\\\"\",\"point\":{\"x\":1.0,\"y\":2.0,\"z\":3.0},\"list\":[1,2],\"kind\":2,\"m_Flag\":true}"));

    [Test]
    public void ReadsWhatItWroteAndKeepsDefaults()
    {
        Sample sample = JsonUtility.FromJson<Sample>("{\"count\":7,\"point\":{\"y\":9},\"list\":[4],\"m_Flag\":false}");
        Assert.That(sample.count, Is.EqualTo(7));
        Assert.That(sample.size, Is.EqualTo(1.5f));
        Assert.That(sample.point, Is.EqualTo(new Vector3(1f, 9f, 3f)));
        Assert.That(sample.list, Is.EqualTo(new[] { 4 }));
        Assert.That(sample.Flag, Is.False);
        Assert.Throws<ArgumentException>(() => JsonUtility.FromJson<Sample>("{oops"));
    }
}
