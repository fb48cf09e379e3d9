using NUnit.Framework;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

public class EditorStandInTests : EngineFixture
{
    DataSample m_Data = null!;

    [SetUp]
    public void CreateData() => m_Data = ScriptableObject.CreateInstance<DataSample>();

    [TearDown]
    public void DestroyData() => Object.DestroyImmediate(m_Data);

    [Test]
    public void PropertiesAreWrittenByApply()
    {
        m_Data.curve = new[] { 1, 2 };
        using var serialized = new SerializedObject(m_Data);
        serialized.FindProperty("speed").floatValue = 4f;
        serialized.FindProperty("curve").GetArrayElementAtIndex(1).intValue = 9;
        serialized.FindProperty("choice").enumValueIndex = 1;
        Assert.That(m_Data.speed, Is.EqualTo(1f));
        Assert.That(serialized.ApplyModifiedProperties(), Is.True);
        Assert.That(serialized.ApplyModifiedProperties(), Is.False);
        Assert.That(m_Data.speed, Is.EqualTo(4f));
        Assert.That(m_Data.curve, Is.EqualTo(new[] { 1, 9 }));
        Assert.That(m_Data.choice, Is.EqualTo(SendMessageOptions.DontRequireReceiver));
        Undo.PerformUndo();
        Assert.That(m_Data.speed, Is.EqualTo(1f));
        Assert.That(m_Data.curve, Is.EqualTo(new[] { 1, 2 }));
    }

    [Test]
    public void PropertiesDescribeThemselves()
    {
        using var serialized = new SerializedObject(m_Data);
        SerializedProperty speed = serialized.FindProperty("speed");
        Assert.That(speed.tooltip, Is.EqualTo("How fast."));
        Assert.That(speed.displayName, Is.EqualTo("Speed"));
        Assert.That(speed.propertyType, Is.EqualTo(SerializedPropertyType.Float));
        Assert.That(serialized.FindProperty("tint").propertyType, Is.EqualTo(SerializedPropertyType.Color));
        Assert.That(serialized.FindProperty("nothing"), Is.Null);
        serialized.FindProperty("curve").arraySize = 3;
        serialized.ApplyModifiedProperties();
        Assert.That(m_Data.curve, Has.Length.EqualTo(3));
    }

    [Test]
    public void UndoTakesBackTheLastGroup()
    {
        var a = new GameObject("A");
        Undo.IncrementCurrentGroup();
        Undo.RecordObject(a.transform, "Move");
        a.transform.position = Vector3.one;
        GameObject created = UnityEditor.ObjectFactory.CreateGameObject("New");
        Undo.PerformUndo();
        Assert.That(a.transform.position, Is.EqualTo(Vector3.zero));
        Assert.That(created == null, Is.True);
    }

    [Test]
    public void MenusCanAlignAndName()
    {
        var parent = new GameObject("P") { layer = 4 };
        var first = new GameObject("C");
        var second = new GameObject("C");
        GameObjectUtility.SetParentAndAlign(first, parent);
        GameObjectUtility.SetParentAndAlign(second, parent);
        GameObjectUtility.EnsureUniqueNameForSibling(second);
        Assert.That(second.name, Is.EqualTo("C (1)"));
        Assert.That(second.layer, Is.EqualTo(4));
        Assert.That(EditorUtility.FormatBytes(1536), Is.EqualTo("1.5 KB"));
    }

    [Test]
    public void OnlyChangedPropertiesAreWrittenToSeveralObjects()
    {
        DataSample other = ScriptableObject.CreateInstance<DataSample>();
        (m_Data.speed, other.speed) = (1f, 2f);
        (m_Data.curve, other.curve) = (new[] { 1, 2 }, new[] { 1, 3 });
        using var serialized = new SerializedObject(new Object[] { m_Data, other });
        Assert.That(serialized.FindProperty("speed").hasMultipleDifferentValues, Is.True);
        Assert.That(serialized.FindProperty("curve").hasMultipleDifferentValues, Is.True);
        Assert.That(serialized.FindProperty("curve").GetArrayElementAtIndex(0).hasMultipleDifferentValues, Is.False);
        Assert.That(serialized.FindProperty("choice").hasMultipleDifferentValues, Is.False);
        serialized.FindProperty("choice").enumValueIndex = 1;
        serialized.ApplyModifiedProperties();
        Assert.That(other.choice, Is.EqualTo(SendMessageOptions.DontRequireReceiver));
        Assert.That(other.speed, Is.EqualTo(2f));
        Assert.That(other.curve, Is.EqualTo(new[] { 1, 3 }));
        Object.DestroyImmediate(other);
    }
}
