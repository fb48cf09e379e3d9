using System.Reflection;
using Headless.Importers;
using Headless.Importers.Scenes;
using Headless.Importers.Serialization;
using Headless.Importers.Yaml;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Importers;

public sealed class ScriptReaderTests
{
    private readonly List<string> reports = [];
    private SerializedSample target = null!;
    private SerializedSample other = null!;

    private sealed class Resolver(Func<long, UnityEngine.Object?> find) : IReferenceResolver
    {
        public UnityEngine.Object? Resolve(FileReference reference, Type expected, string where) => find(reference.FileId);
    }

    [SetUp]
    public void SetUp()
    {
        reports.Clear();
        target = ScriptableObject.CreateInstance<SerializedSample>();
        other = ScriptableObject.CreateInstance<SerializedSample>();
    }

    private SerializedSample Read(string yaml)
    {
        var reader = new ScriptReader(new Resolver(id => id == 5 ? other : null), name => name == "Tests" ? Assembly.GetExecutingAssembly() : null, reports.Add);
        reader.Fill(target, UnityYaml.ParseMap(yaml, "t"), new SourceScope("t"), "t: Sample");
        return target;
    }

    [Test]
    public void ScalarsAndEngineValues()
    {
        SerializedSample s = Read("""
            flag: 1
            number: -3
            big: 9223372036854775807
            real: 0.33333334
            text: hello
            kind: 2
            vector: {x: 1, y: 2, z: 3}
            rotation: {x: 0, y: 1, z: 0, w: 0}
            colour: {r: 0.5, g: 0.25, b: 1, a: 0.75}
            bounds:
              m_Center: {x: 1, y: 1, z: 1}
              m_Extent: {x: 2, y: 3, z: 4}
            rect:
              serializedVersion: 2
              x: 1
              y: 2
              width: 3
              height: 4
            mask:
              serializedVersion: 2
              m_Bits: 4294967295
            """);
        Assert.That((s.flag, s.number, s.big, s.real, s.text, s.kind), Is.EqualTo((true, -3, long.MaxValue, 1f / 3, "hello", SerializedSample.Kind.Second)));
        Assert.That(s.vector, Is.EqualTo(new Vector3(1, 2, 3)));
        Assert.That(s.rotation, Is.EqualTo(new Quaternion(0, 1, 0, 0)));
        Assert.That(s.colour, Is.EqualTo(new Color(0.5f, 0.25f, 1, 0.75f)));
        Assert.That(s.bounds, Is.EqualTo(new Bounds(Vector3.one, new Vector3(4, 6, 8))));
        Assert.That(s.rect, Is.EqualTo(new Rect(1, 2, 3, 4)));
        Assert.That(s.mask.value, Is.EqualTo(-1));
    }

    [Test]
    public void PackedArraysAreLittleEndianHexadecimal()
    {
        SerializedSample s = Read("packed: 01000000070000000e000000ffffffff\npackedFlags: 010001\npackedKinds: 0201\nkinds: ");
        Assert.That(s.packed, Is.EqualTo(new[] { 1, 7, 14, -1 }));
        Assert.That(s.packedFlags, Is.EqualTo(new[] { true, false, true }));
        Assert.That(s.packedKinds, Is.EqualTo(new[] { SerializedSample.Kind.Second, SerializedSample.Kind.First }));
        Assert.That(s.kinds, Is.Empty);
    }

    [Test]
    public void ListsAndNestedClasses()
    {
        SerializedSample s = Read("texts:\n- a\n- b\nreals:\n- 0.5\nsection:\n  title: one\n  ids: 02000000\n  range:\n    low: -1\n    high: 1\nsections:\n- title: x\n- {}\n");
        Assert.That(s.texts, Is.EqualTo(new[] { "a", "b" }));
        Assert.That(s.reals, Is.EqualTo(new[] { 0.5f }));
        Assert.That((s.section.title, s.section.ids![0], s.section.range.low, s.section.range.high), Is.EqualTo(("one", 2, -1f, 1f)));
        Assert.That(s.sections!.Select(x => x.title), Is.EqualTo(new[] { "x", "untitled" }));
    }

    [Test]
    public void AbsentFieldsKeepDefaultsAndAreNeverNull()
    {
        SerializedSample s = Read("number: 1");
        Assert.That((s.text, s.section.title), Is.EqualTo(("default", "untitled")));
        Assert.That(s.packed, Is.Empty);
        Assert.That(s.sections, Is.Empty);
        Assert.That(s.section.ids, Is.Null.Or.Empty);
        Assert.That(s.reference, Is.Null);
    }

    [Test]
    public void PrivateRenamedAndBackingFields()
    {
        SerializedSample s = Read("hidden: 11\noldName: 12\n<Viscosity>k__BackingField: 0.5\nplainPrivate: 99\nnotSerialized: 99\nReadOnly: 99");
        Assert.That((s.Hidden, s.Renamed, s.Viscosity), Is.EqualTo((11, 12, 0.5f)));
        Assert.That((s.PlainPrivate, s.notSerialized, s.ReadOnly), Is.EqualTo((5, 4, 3)));
    }

    [Test]
    public void TheNewNameWinsOverTheOld() => Assert.That(Read("oldName: 1\nrenamed: 2").Renamed, Is.EqualTo(2));

    [Test]
    public void References()
    {
        SerializedSample s = Read("reference: {fileID: 5}\nreferences:\n- {fileID: 5}\n- {fileID: 0}\n");
        Assert.That(s.reference, Is.SameAs(other));
        Assert.That(s.references, Is.EqualTo(new ScriptableObject?[] { other, null }));
    }

    [TestCase("e4f0cf58ea8e6ce4ea3c8d7a1a1a4f3e")]
    [TestCase("12345678")]
    [TestCase("1e5")]
    public void AnExposedReferenceHasANameAndADefault(string name)
    {
        SerializedSample s = Read($"exposed:\n  exposedName: {name}\n  defaultValue: {{fileID: 5}}\n");
        Assert.That((s.exposed.exposedName, s.exposed.Resolve(null!)), Is.EqualTo((new PropertyName(name), other)));
        s = Read("exposed:\n  exposedName: \n  defaultValue: {fileID: 0}\n");
        Assert.That(PropertyName.IsNullOrEmpty(s.exposed.exposedName));
        Assert.That(s.exposed.defaultValue == null);
        Assert.That(reports, Is.Empty);
    }

    [Test]
    public void ManagedReferences()
    {
        SerializedSample s = Read("""
            shape:
              rid: 1000
            shapes:
            - rid: -2
            - rid: 1000
            references:
              version: 2
              RefIds:
              - rid: -2
                type: {class: , ns: , asm: }
              - rid: 1000
                type: {class: SerializedSample/Circle, ns: Headless.Tests.Importers, asm: Tests}
                data:
                  radius: 2.5
            """);
        Assert.That((s.shape as SerializedSample.Circle)?.radius, Is.EqualTo(2.5f));
        Assert.That(s.shapes, Is.EqualTo(new[] { null, s.shape }));
    }

    [Test]
    public void AManagedReferenceOfAnUnknownClassIsReported()
    {
        Assert.That(Read("shape:\n  rid: 1\nreferences:\n  version: 2\n  RefIds:\n  - rid: 1\n    type: {class: Gone, ns: A, asm: Tests}\n").shape, Is.Null);
        Assert.That(reports.Single(), Does.Contain("A.Gone"));
    }

    [Test]
    public void TheCallbackIsCalledOnce() => Assert.That(Read("number: 1").Callbacks, Is.EqualTo(1));

    [Test]
    public void AWrongValueNamesLineAndField()
    {
        var error = Assert.Throws<ImportException>(() => Read("number: many"));
        Assert.That(error!.Message, Does.StartWith("t:1: 'number' must be a whole number").And.Contain("found 'many'"));
    }

    [Test]
    public void OnlyUnitysFieldsAreSerialised() =>
        Assert.That(SerializationRules.FieldsOf(typeof(SerializedSample)).Select(f => f.Field.Name),
            Does.Not.Contain("dictionary").And.Not.Contain("Static").And.Not.Contain("Constant").And.Not.Contain("ReadOnly").And.Not.Contain("notSerialized").And.Not.Contain("plainPrivate"));
}
