using System.Collections;
using System.Reflection;
using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using UnityEngine;

namespace Headless.Importers.Serialization;

/// <summary>Fills the fields of a script object from its YAML. A field without an entry keeps the value its constructor gave it.</summary>
public sealed class ScriptReader(IReferenceResolver references, Func<string, Assembly?> assemblies, Action<string> report)
{
    /// <summary>Unity's limit for nested serialised classes.</summary>
    private const int MaximumDepth = 10;
    private const string FieldWord = ", field '";

    private readonly record struct Place(SourceScope Scope, ManagedReferences Managed, string Owner);

    public void Fill(object target, YamlMap body, SourceScope scope, string owner)
    {
        ManagedReferences managed = ManagedReferences.Read(body, assemblies, owner, report);
        var place = new Place(scope, managed, owner);
        foreach (var (instance, data) in managed.Filled) FillFields(instance, data, place, 1);
        FillFields(target, body, place, 0);
        AfterDeserialize(target);
    }

    /// <summary>An exception there is the script's, not the file's: Unity logs it and goes on.</summary>
    private static void AfterDeserialize(object target)
    {
        try
        {
            (target as ISerializationCallbackReceiver)?.OnAfterDeserialize();
        }
        catch (Exception e)
        {
            Debug.LogException(e);
        }
    }

    private void FillFields(object target, YamlMap body, Place place, int depth)
    {
        foreach (SerializedField field in SerializationRules.FieldsOf(target.GetType()))
        {
            FieldInfo info = field.Field;
            object? current = info.GetValue(target);
            YamlNode? node = null;
            foreach (string name in field.Names)
                if ((node = name == ManagedReferences.Key && ManagedReferences.IsTable(body[name]) ? null : body[name]) is not null) break;
            string where = $"{place.Owner}, field '{info.Name}'";
            try
            {
                object? value = node is null ? Absent(info.FieldType, current, field.ByReference, depth)
                    : field.ByReference ? ReadManaged(node, info.FieldType, place)
                    : Read(node, info.FieldType, current, place, where, depth);
                info.SetValue(target, value);
            }
            catch (Exception e) when (e is ArgumentException or InvalidCastException or OverflowException)
            {
                throw ImportException.At((node ?? body).Place.ToString(), $"{where}: {e.Message}", inner: e);
            }
        }
    }

    /// <summary>Serialised strings, lists and classes are never null after loading.</summary>
    private static object? Absent(Type type, object? current, bool byReference, int depth)
    {
        if (current is not null || byReference || typeof(UnityEngine.Object).IsAssignableFrom(type)) return current;
        if (type == typeof(string)) return "";
        if (SerializationRules.ElementType(type) is { } element) return ToList(type, Array.CreateInstance(element, 0));
        return depth < MaximumDepth && type.IsDefined(typeof(SerializableAttribute), false) ? ManagedReferences.Create(type) : null;
    }

    private object? Read(YamlNode node, Type type, object? current, Place place, string where, int depth)
    {
        if (typeof(UnityEngine.Object).IsAssignableFrom(type))
        {
            if (FileReference.Is(node) || IsNothing(node)) return references.Resolve(FileReference.Read(node, place.Scope), type, where);
            return OtherKind(node, "a reference", null, where);
        }
        if (SerializationRules.ElementType(type) is { } element) return ToList(type, ReadElements(node, element, place, where, depth));
        if (ValueReaders.Knows(type))
        {
            if (node is YamlMap map) return ValueReaders.Read(type, map);
            if (type == typeof(LayerMask) && node is YamlScalar { IsEmpty: false } bits) return (LayerMask)YamlValue.Int(bits, NameIn(where));
            return OtherKind(node, $"a {type.Name}", current, where);
        }
        if (node is YamlScalar scalar && (type.IsPrimitive || type.IsEnum || type == typeof(string))) return Scalars.Read(scalar, type, NameIn(where));
        if (type.IsPrimitive || type.IsEnum || type == typeof(string))
            return OtherKind(node, $"a {type.Name}", current, where);
        if (type == typeof(PropertyName)) return node is YamlScalar name ? new PropertyName(name.Text) : OtherKind(node, "a name", current, where);
        if (node is YamlMap nested) return ReadNested(nested, type, current, place, depth + 1);
        return OtherKind(node, $"a {type.Name}", Absent(type, current, false, depth), where);
    }

    private object? ReadNested(YamlMap map, Type type, object? current, Place place, int depth)
    {
        if (depth > MaximumDepth) return null;
        object target = current ?? ManagedReferences.Create(type);
        FillFields(target, map, place, depth);
        AfterDeserialize(target);
        return target;
    }

    private static bool IsNothing(YamlNode node) => node is YamlScalar { IsEmpty: true } or YamlMap { Count: 0 } or YamlList { Items.Count: 0 };

    /// <summary>A field whose type has changed since the file was written keeps its default, as in Unity; here it is reported.</summary>
    private object? OtherKind(YamlNode node, string expected, object? stays, string where)
    {
        if (!IsNothing(node)) report($"{node.Place}: {where}: {expected} was expected, the file has {node.Kind}; the default stays.");
        return stays;
    }

    /// <summary>The part of a description that a YAML key would be: <c>A.unity: Tank of 'Tank', field 'size'</c> gives <c>size</c>.</summary>
    private static string NameIn(string where)
    {
        int at = where.LastIndexOf(FieldWord, StringComparison.Ordinal);
        return at < 0 ? where : where[(at + FieldWord.Length)..].Replace("'", "");
    }

    private Array ReadElements(YamlNode node, Type element, Place place, string where, int depth)
    {
        if (node is YamlScalar packed)
            return packed.IsEmpty ? Array.CreateInstance(element, 0)
                : element.IsPrimitive || element.IsEnum ? PackedArray.Read(packed, element, NameIn(where))
                : throw YamlValue.Wrong(packed, NameIn(where), "a list");
        if (node is not YamlList) OtherKind(node, "a list", null, where);
        IReadOnlyList<YamlNode> items = node is YamlList list ? list.Items : [];
        Array result = Array.CreateInstance(element, items.Count);
        for (int i = 0; i < items.Count; i++)
            result.SetValue(Read(items[i], element, null, place, $"{where}[{i}]", depth), i);
        return result;
    }

    private static object? ReadManaged(YamlNode node, Type type, Place place)
    {
        if (SerializationRules.ElementType(type) is { } element && node is YamlList list)
        {
            Array result = Array.CreateInstance(element, list.Items.Count);
            for (int i = 0; i < list.Items.Count; i++) result.SetValue(ReadManaged(list.Items[i], element, place), i);
            return ToList(type, result);
        }
        object? found = node is YamlMap map ? place.Managed.Find(map.Long("rid", ManagedReferences.Null)) : null;
        return type.IsInstanceOfType(found) ? found : null;
    }

    private static object ToList(Type type, Array items)
    {
        if (type.IsArray) return items;
        var list = (IList)Activator.CreateInstance(type)!;
        foreach (object? item in items) list.Add(item);
        return list;
    }
}
